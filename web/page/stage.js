// The crowd on its ground, drawn from the palettes as they are in wasm's memory.
import { program } from "./gl.js";
import { ANKLE, JOINTS, ground, sizes } from "./person.js";

const BODY = `layout(location=0) in vec3 corner; layout(location=1) in vec3 normal; layout(location=2) in mat4 pose;
uniform mat4 view; uniform vec3 sizes[${JOINTS}]; out vec3 n; flat out float who;
void main() {
  n = mat3(pose) * normal; who = float(gl_InstanceID / ${JOINTS});
  gl_Position = view * pose * vec4(corner * sizes[gl_InstanceID % ${JOINTS}], 1.);
}`;
const CLOTH = `precision highp float; in vec3 n; flat in float who; out vec4 colour;
void main() {
  vec3 tint = .55 + .3 * cos(who * 2.4 + vec3(0., 2., 4.));
  colour = vec4(tint * (.45 + .55 * max(0., dot(normalize(n), normalize(vec3(.4, .8, .5))))), 1.);
}`;
const GROUND = `layout(location=0) in vec3 corner; uniform mat4 view; out vec3 p;
void main() { p = corner; gl_Position = view * vec4(corner, 1.); }`;
const EARTH = `precision highp float; in vec3 p; out vec4 colour;
void main() {
  vec3 n = normalize(cross(dFdx(p), dFdy(p)));
  colour = vec4(vec3(.62, .66, .52) * (.5 + .5 * n.y * n.y), 1.);
}`;
/** Squares of the ground on a side, and the distance of people. */
const SQUARES = 64,
  APART = 1.1;
const QUAD = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]];

/** Corners of a cube with their normals. */
function cube() {
  const made = [];
  for (let axis = 0; axis < 3; axis++)
    for (const side of [-1, 1])
      for (const corner of QUAD) {
        const [p, n] = [[0, 0, 0], [0, 0, 0]];
        p[axis] = n[axis] = side;
        corner.forEach((x, k) => (p[(axis + 1 + k) % 3] = 2 * x - 1));
        made.push(...p, ...n);
      }
  return Float32Array.from(made);
}

function soil(size) {
  const at = (k) => size * (k / SQUARES - 0.5),
    made = [];
  for (let i = 0; i < SQUARES; i++)
    for (let k = 0; k < SQUARES; k++)
      for (const [a, b] of QUAD) {
        const [x, z] = [at(i + a), at(k + b)];
        made.push(x, ground(x, z) - ANKLE / 3, z);
      }
  return Float32Array.from(made);
}

/** In perspective, from where all of a square of this size is seen. */
function camera([r, u, f], wide, size) {
  const zoom = 1.7,
    near = 0.1,
    far = 0.93 * size * Math.max(1, 1.25 / wide) + 2,
    back = 4 * far,
    view = new Float32Array(16),
    middle = 0.8 - 0.07 * size,
    eye = (row, extra) => -middle * row[1] - extra;
  const [depth, shift] = [(back + near) / (near - back), (2 * back * near) / (near - back)];
  for (let k = 0; k < 3; k++) view.set([(zoom / wide) * r[k], zoom * u[k], depth * f[k], -f[k]], 4 * k);
  view.set([(zoom / wide) * eye(r, 0), zoom * eye(u, 0), depth * eye(f, far) + shift, -eye(f, far)], 12);
  return view;
}

export class Stage {
  #gl;
  #body;
  #earth;
  #people;
  #field;
  #poses;
  #soil;
  #size = 0;
  #room = 0;
  #corners = cube();
  constructor(gl) {
    this.#gl = gl;
    [this.#body, this.#earth] = [program(gl, BODY, CLOTH), program(gl, GROUND, EARTH)];
    [this.#people, this.#field] = [gl.createVertexArray(), gl.createVertexArray()];
    const rows = (place, width, stride, each) => {
      for (let k = 0; k < each; k++) {
        gl.enableVertexAttribArray(place + k);
        gl.vertexAttribPointer(place + k, width, gl.FLOAT, false, stride, 4 * width * k);
      }
    };
    gl.bindVertexArray(this.#people);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, this.#corners, gl.STATIC_DRAW);
    rows(0, 3, 24, 2);
    gl.bindBuffer(gl.ARRAY_BUFFER, (this.#poses = gl.createBuffer()));
    rows(2, 4, 64, 4);
    for (let k = 2; k < 6; k++) gl.vertexAttribDivisor(k, 1);
    gl.bindVertexArray(this.#field);
    gl.bindBuffer(gl.ARRAY_BUFFER, (this.#soil = gl.createBuffer()));
    rows(0, 3, 12, 1);
    gl.useProgram(this.#body);
    gl.uniform3fv(gl.getUniformLocation(this.#body, "sizes"), sizes);
    gl.enable(gl.DEPTH_TEST);
  }
  /** Palettes of batches, in turn; those that are there if none are given. */
  draw(axes, people, palettes) {
    const gl = this.#gl,
      { width, height } = gl.canvas,
      size = APART * Math.ceil(Math.sqrt(people)) + 1.5;
    if (this.#size !== size) {
      this.#size = size;
      gl.bindBuffer(gl.ARRAY_BUFFER, this.#soil);
      gl.bufferData(gl.ARRAY_BUFFER, soil(size), gl.STATIC_DRAW);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#poses);
    if (this.#room !== people) gl.bufferData(gl.ARRAY_BUFFER, 64 * JOINTS * (this.#room = people), gl.DYNAMIC_DRAW);
    let at = 0;
    for (const { view } of palettes) {
      gl.bufferSubData(gl.ARRAY_BUFFER, at, view);
      at += view.byteLength;
    }
    const view = camera(axes, width / height, size);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const [of, field] of [[this.#earth, this.#field], [this.#body, this.#people]]) {
      gl.useProgram(of);
      gl.uniformMatrix4fv(gl.getUniformLocation(of, "view"), false, view);
      gl.bindVertexArray(field);
      if (field === this.#field) gl.drawArrays(gl.TRIANGLES, 0, 6 * SQUARES * SQUARES);
      else gl.drawArraysInstanced(gl.TRIANGLES, 0, this.#corners.length / 6, people * JOINTS);
    }
  }
}
