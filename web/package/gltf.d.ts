/** A skeleton of rigid joints with its clips and skins, in the arrays that `dq8` takes. */
export interface Rig<S extends RigSkin = RigSkin> {
  /**
   * Of each joint the joint that it hangs from, -1 for none: for `dq8.skeleton`. Parents come
   * first.
   */
  parents: Int32Array;
  /** Names of the joints. */
  names: string[];
  /** Local poses at rest, [joint][x y z w tx ty tz]. */
  rest: Float32Array;
  clips: RigClip[];
  skins: S[];
  /** Parts of the source that have no place here, such as morph targets. */
  left: string[];
}

export interface RigClip {
  name: string;
  /**
   * Frames of local poses, [frame][joint][x y z w tx ty tz]: for `skeleton.clip(keys, { rate })`.
   */
  keys: Float32Array;
  frames: number;
  /** Frames a second: the wanted rate, or a little more, so that the last frame lies on the end. */
  rate: number;
  /** Seconds from 0 to the last key. */
  duration: number;
  /**
   * The largest difference between the tracks and the frames, between which `dq8` goes straight: an
   * angle in radians and a distance, and where they are, if there is any. A track that steps takes
   * the time of a frame for it. NaN with `error: false`.
   */
  error: { rotation: number; translation: number; rotationAt?: RigPlace; translationAt?: RigPlace };
}

/** A joint at a time in seconds. */
export interface RigPlace {
  joint: number;
  time: number;
}

export interface RigSkin {
  name: string;
  /** Of each joint of the source's skin the joint of `parents`: where its skin indices lead. */
  joints: Uint16Array;
  /** Inverse binds of all joints as motions, eight numbers each: for `dq8.motions`. */
  inverseBinds: Float32Array;
  /**
   * Positions of the mesh must be multiplied by this before the joints move them. It is 1 if
   * inverse binds undo the scale of the joints.
   */
  scale: number;
}

export interface GltfSkin extends RigSkin {
  primitives: GltfPrimitive[];
}

/** A part of a mesh that follows joints; `dq8.skin({ jointCount, ...primitive })` takes it. */
export interface GltfPrimitive {
  /** The name of its mesh. */
  mesh: string;
  /** Its place in the file. */
  place: string;
  /** 4 for triangles, as in WebGL. */
  mode: number;
  /** Multiplied by the scale of the skin. */
  positions: Float32Array;
  normals?: Float32Array;
  indices: Uint32Array;
  /** 4, or 8 with JOINTS_1. */
  influences: number;
  /** Joints of the skeleton, [vertex][influence]. */
  joints: Uint16Array;
  /** Weights of a vertex have the sum 1. */
  weights: Float32Array;
}

export interface RigOptions {
  /** The frames a second that tracks are resampled at, 30 without it. */
  rate?: number;
  /** `false` does not measure the error of clips, and reads long ones in a third of the time. */
  error?: boolean;
  /** How far scales may be from one constant uniform scale, relative to it; 0.001 without it. */
  tolerance?: number;
}

export interface GltfOptions extends RigOptions {
  /** `false` reads no meshes, as where a viewer has them or they are compressed. */
  meshes?: boolean;
  /** The skins and animations that are read, by name or number; all without them. */
  skins?: readonly (string | number)[];
  animations?: readonly (string | number)[];
}

/** JSON and buffers of a glTF; buffers in the JSON as base64 are not needed. */
export interface GltfSource {
  json: object;
  buffers?: readonly (ArrayBufferLike | ArrayBufferView | undefined)[];
}

/**
 * Motions, eight numbers each, of 4×4 matrices by columns: for `dq8.motions`. A matrix that scales
 * or shears is an error.
 */
export function fromMatrices(matrices: Float32Array | Float64Array | number[]): Float32Array;

/** Takes a binary glTF apart. */
export function readGlb(file: ArrayBufferLike | ArrayBufferView): GltfSource;

/**
 * The joints of all skins as one skeleton, with their clips and meshes: of a .glb, or of JSON and
 * buffers. Nodes above the joints that no clip moves are folded into them, and so is a constant
 * uniform scale. A scale that changes or is not uniform, a matrix that shears, or compressed
 * numbers are an error that names them.
 */
export function readGltf(file: ArrayBufferLike | ArrayBufferView | GltfSource, options?: GltfOptions): Rig<GltfSkin>;

export interface ThreeOptions extends RigOptions {
  /**
   * The object whose space poses are in, such as the scene of a file; without it all that the bones
   * hang from counts.
   */
  root?: object;
  /** The bind matrix of the mesh, if it is not the identity: `mesh.bindMatrix`. */
  bindMatrix?: { elements: ArrayLike<number> };
}

interface ThreeNode {
  name: string;
  parent: unknown;
  quaternion: { x: number; y: number; z: number; w: number };
  position: { x: number; y: number; z: number };
  scale: { x: number; y: number; z: number };
}

/**
 * The same of a `Skeleton` and `AnimationClip`s of three.js, whose meshes stay there. Bones that no
 * clip moves stay where they are.
 */
export function readThree(
  skeleton: { bones: readonly ThreeNode[]; boneInverses: readonly { elements: ArrayLike<number> }[] },
  clips?: readonly { name: string; duration: number; tracks: readonly { name: string }[] }[],
  options?: ThreeOptions,
): Rig;
