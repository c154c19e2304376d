/*
 * dq8: rigid motions as dual quaternions, many at a time. Generated from capi/src by capi/header.sh;
 * do not edit.
 *
 * A motion is eight numbers, px py pz pw qx qy qz qw. The dual quaternion p + eq rotates by p, then
 * translates by t, where q = tp/2. In a product a * b, b acts first. Angles are in radians, lengths
 * in your unit.
 *
 * Names.    dq8_motion_NAME computes one motion, dq8_mechanism_NAME one configuration of a mechanism,
 *           dq8_skin_NAME a mesh, dq8_plan_NAME one instance of a hierarchy in the fastest order,
 *           dq8_clips_NAME packed clips, and dq8_trajectory_NAME and dq8_spline_NAME poses over
 *           time, and dq8_urdf_NAME reads files of robots, if the library has the feature `urdf`.
 *           dq8_NAME computes plain arrays, and dq8_blocks_NAME the same on blocks, which is fastest.
 *           All have a form for float (_f32) and one for double (_f64); dq8_generic.h has one name
 *           for both (C11).
 * Blocks.   A block holds `lanes` things, component after component: with 8 lanes, the eight px, then
 *           the eight py, and so on. Its size is rounded up to whole 64 bytes (dq8_block_size).
 *           float has blocks of 8 and 16 lanes, double of 4 and 8.
 * Errors.   Every call returns a dq8_status. If it is not DQ8_STATUS_OK, the outputs are as they were,
 *           except an index such as `bad_joint`, the steps of a mechanism, and scratch.
 * Memory.   All memory is yours. The library allocates nothing and keeps no pointer after it returns.
 *           (dq8_resample, dq8_clips_pack, dq8_urdf_NAME, dq8_trajectory_NAME and dq8_spline_NAME alone
 *           allocate while they run. Without std, as for firmware, the library does not have them.)
 *           But a dq8_mechanism points to its steps, a dq8_skin to its joints and weights, and
 *           dq8_clips to their bytes: do not change or free these, or the behaviour is undefined. A
 *           pointer may be null if the length of its array is 0.
 * Align.    Arrays must have the alignment of their number type, and blocks that of 64 bytes.
 * Aliasing. Inputs may overlap each other. An output (an array, or one thing such as a motion) must not
 *           overlap an input or another output, unless a function says that it may be one of the
 *           inputs; then it must be exactly that array. Functions of one motion read all inputs before
 *           they write, so there an output may overlap inputs.
 * Checked.  Null and misaligned pointers, overlaps and lengths are errors. Wrong numbers in arrays give
 *           wrong results, but no crash, except in the memory of a mechanism, a skin or clips. The
 *           library cannot check that an array is as long as you say, and does not check that a
 *           motion is unit where it must be.
 * Threads.  The library has no threads. Give each of yours its own part of the arrays: the results have
 *           the same bits. Calls do not affect each other, except that dq8_backend_limit and
 *           dq8_set_reproducible hold for all threads.
 */

/*
 * Contents, without _f32 and _f64.
 *
 * One motion
 *   dq8_motion_from_euler                      Makes the rotation about the origin of three turns about coordinate ...
 *   dq8_motion_to_euler                        Writes the three Euler angles of the rotation of a unit motion, in ...
 *   dq8_motion_line                            Moves a line by a unit motion
 *   dq8_motion_plane                           Moves a plane by a unit motion
 *   dq8_motion_twist                           Applies the adjoint of a unit motion to a twist, which turns a body ...
 *   dq8_motion_to_twist                        Writes the constant twist that moves the identity to a unit motion ...
 *   dq8_motion_integrate_body                  Moves a unit motion on by a constant body twist for `dt` seconds
 *   dq8_motion_angle_to                        Writes the angle between two unit motions, in radians from 0 to pi
 *   dq8_motion_distance_to                     Writes the distance between the translations of two unit motions
 *   dq8_motion_mean                            Computes the intrinsic mean of `count` unit motions
 *   dq8_motion_identity                        Writes the identity
 *   dq8_motion_from_rotation_translation       Makes the motion that rotates by the unit quaternion `rotation` (x, ...
 *   dq8_motion_to_rotation_translation         Writes the parts of a unit motion
 *   dq8_motion_from_matrix_3x4                 Makes the motion of a matrix of three rows and four columns
 *   dq8_motion_from_matrix_4x4                 Makes the motion of a matrix of four rows and four columns
 *   dq8_motion_to_matrix_3x4                   Writes the matrix `[R | t]` of a unit motion
 *   dq8_motion_to_matrix_4x4                   Writes the 4x4 matrix of a unit motion, with the last row 0 0 0 1: ...
 *   dq8_motion_mul                             Computes the product `a * b`, in which b acts first
 *   dq8_motion_conjugate                       Computes the inverse of a unit motion, which only flips signs
 *   dq8_motion_inverse                         Computes the inverse of a motion that need not be unit
 *   dq8_motion_normalize                       Normalizes a dual quaternion to a unit motion
 *   dq8_motion_check_unit                      Checks that a motion is unit
 *   dq8_motion_point                           Moves a point (x, y, z) by a unit motion
 *   dq8_motion_vector                          Turns a direction (x, y, z) by a unit motion, which does not ...
 *   dq8_motion_nlerp                           Interpolates from `a` (t = 0) to `b` (t = 1) by the shorter way
 *   dq8_motion_sclerp                          Interpolates along one screw, from unit `a` (t = 0) to unit `b` (t ...
 *   dq8_motion_blend                           Blends `count` unit motions by `weights`, which need not sum to 1. ...
 *   dq8_motion_log                             Writes the logarithm of a unit motion
 *   dq8_motion_exp                             Writes the unit motion whose logarithm is `log`
 *   dq8_motion_pow                             Raises a unit motion to the power `t`
 *   dq8_motion_to_screw                        Writes the screw of a unit motion as eight values
 *   dq8_motion_from_screw                      Writes the motion of a screw, which `numbers` gives as eight values
 *
 * One instance of a hierarchy, in the fastest order
 *   dq8_plan_make                              Finds the fastest order of joints for dq8_plan_local_to_model
 *   dq8_plan_local_to_model                    Computes model poses like dq8_local_to_model, in a faster order
 *
 * Packed clips
 *   dq8_clips_bound                            Writes a number of bytes that the file of these clips does not ...
 *   dq8_clips_pack                             Packs clips of one skeleton into a file, which dq8_clips_make reads
 *   dq8_clips_make                             Makes `clips` from the `length` bytes of a packed clip file
 *   dq8_clips_duration                         Writes the time from the first to the last frame of a clip
 *   dq8_clips_place                            Finds the time `at` in a clip
 *   dq8_clips_to_model                         Computes the model poses of instances that play packed clips
 *
 * Poses at stamps
 *   dq8_trajectory_sample                      Samples the poses and velocities of a trajectory at `count` times
 *   dq8_trajectory_deskew                      Moves points, which a moving body has measured, into one frame
 *   dq8_trajectory_skew                        Computes the inverse of dq8_trajectory_deskew
 *
 * A smooth curve by control poses
 *   dq8_spline_poses                           Samples the poses of a cubic spline, and its twists, at `count` times
 *
 * Joints from URDF files, if DQ8_URDF is defined
 *   dq8_urdf_size                              Reads a URDF file, of which `text` holds `length` bytes, and writes ...
 *   dq8_urdf_joints                            Reads the joints of a URDF file, of which `text` holds `length` bytes
 *
 * One configuration of a mechanism
 *   dq8_mechanism_make                         Makes a mechanism of `count` joints
 *   dq8_mechanism_link_poses                   Computes the poses of all links in the frame of the base
 *   dq8_mechanism_link_pose                    Computes the pose of one link in the frame of the base
 *   dq8_mechanism_link_jacobian                Computes the geometric Jacobian of a link
 *   dq8_mechanism_manipulability               Computes the manipulability of a link
 *   dq8_mechanism_rates_for                    Computes the rates that move a link best with the velocity `twist`
 *   dq8_mechanism_reach_options                Writes the default options
 *   dq8_mechanism_reach_scratch                Writes the size that `scratch` of dq8_mechanism_reach must have
 *   dq8_mechanism_reach                        Solves the inverse kinematics of one configuration
 *
 * A joint of a mechanism, filled in
 *   dq8_joint_fixed                            Returns a joint that does not move
 *   dq8_joint_revolute                         Returns a joint that turns about `axis`
 *   dq8_joint_prismatic                        Returns a joint that slides along `axis`
 *   dq8_joint_screw                            Returns a joint that turns about `axis` and slides along it by ...
 *   dq8_joint_planar                           Returns a joint that slides at right angles to `axis` and turns ...
 *   dq8_joint_floating                         Returns a joint that moves freely
 *
 * A mesh
 *   dq8_skin_products                          Computes a palette of matrices, `matrices[j] = models[j] * ...
 *   dq8_skin_split                             Splits the matrices of a palette into stretches and unit motions
 *   dq8_skin_make                              Makes a skin of the joints that move each vertex and their weights
 *   dq8_skin_make_interleaved                  Makes a skin of a vertex buffer, otherwise like dq8_skin_make
 *   dq8_skin_linear_interleaved                Poses a vertex buffer, like the function without _interleaved poses ...
 *   dq8_skin_linear                            Poses a mesh by linear blends
 *   dq8_skin_dual_interleaved                  Poses a vertex buffer, like the function without _interleaved poses ...
 *   dq8_skin_dual                              Poses a mesh by dual quaternion blends, otherwise like dq8_skin_linear
 *   dq8_skin_stretched_interleaved             Poses a vertex buffer, like the function without _interleaved poses ...
 *   dq8_skin_stretched                         Poses a mesh whose joints scale or shear, otherwise like dq8_skin_dual
 *   dq8_skin_mixed_interleaved                 Poses a vertex buffer, like the function without _interleaved poses ...
 *   dq8_skin_mixed                             Poses a mesh by a mix of dq8_skin_linear and dq8_skin_dual
 *
 * Arrays: dq8_NAME plain, dq8_blocks_NAME in blocks of lanes
 *   dq8_chain_products                         Computes `out[i] = links[0] * links[1] * ... * links[i]`, the model ...
 *   dq8_local_to_model                         Computes model poses from local poses
 *   dq8_model_to_local                         Computes local poses from unit model poses
 *   dq8_rotations_to_model                     Computes model poses from rotations and fixed offsets
 *   dq8_rotations_translations_to_model        Computes model poses from rotations and translations
 *   dq8_palette                                Computes model poses and the skinning palette in one pass
 *   dq8_palette_matrices                       Computes model poses and the palette like dq8_palette, but with ...
 *   dq8_link_poses                             Computes the poses of all links for many configurations
 *   dq8_link_jacobians                         Computes the Jacobians and the poses of some links for many ...
 *   dq8_mul                                    Computes the products `a[i] b[i]`, in which b acts first
 *   dq8_normalize                              Normalizes `motions` to unit motions, exactly; NaN where there is none
 *   dq8_inverse                                Computes the inverses of `motions` of any norm; NaN or infinite ...
 *   dq8_conjugate                              Computes the inverses of unit `motions`, which only flips signs
 *   dq8_nlerp                                  Interpolates linearly from `a[i]` (t = 0) to `b[i]` (t = 1) by the ...
 *   dq8_nlerp_each                             Interpolates like `nlerp`, with a number `t[i]` for each pair
 *   dq8_sclerp                                 Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1) by the ...
 *   dq8_sclerp_each                            Interpolates like `sclerp`, with a number `t[i]` for each pair
 *   dq8_slerp_lerp                             Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1)
 *   dq8_slerp_lerp_each                        Interpolates like `slerp_lerp`, with a number `t[i]` for each pair
 *   dq8_pow_each                               Raises the unit `motions[i]` to the power `t[i]`
 *   dq8_exp                                    Computes the unit motions whose logarithms are `logs`, six numbers ...
 *   dq8_from_twist                             Computes the motions to which `twists`, six numbers each, angular ...
 *   dq8_integrate_body                         Moves the unit `motions[i]` on by `dt` seconds of the body twists ...
 *   dq8_log                                    Computes the logarithms of unit `motions`, six numbers each
 *   dq8_to_twist                               Computes the twists, six numbers each, angular part first, that ...
 *   dq8_angles                                 Computes the angles between unit `a[i]` and unit `b[i]`, radians in ...
 *   dq8_distances                              Computes the distances between the translations of unit `a[i]` and ...
 *   dq8_points_each                            Moves `points[i]`, three numbers each, by the unit `motions[i]`
 *   dq8_vectors_each                           Turns `vectors[i]`, three numbers each, by the unit `motions[i]`
 *   dq8_lines_each                             Moves `lines[i]` by the unit `motions[i]`
 *   dq8_planes_each                            Moves `planes[i]` by the unit `motions[i]`
 *   dq8_twists_each                            Applies the adjoint of the unit `motions[i]` to `twists[i]`, six ...
 *   dq8_points                                 Moves `points`, three components each, by one unit `motion`
 *   dq8_vectors                                Turns `vectors`, three components each, by one unit `motion`
 *   dq8_matrices_3x4                           Writes the matrices `[R | t]` of unit `motions`
 *   dq8_matrices_4x4                           Writes the 4x4 matrices of unit `motions`, with the last row 0 0 0 ...
 *
 * Arrays, plain, and the library itself
 *   dq8_backend_name                           Returns the name of the instruction set in use, for logs
 *   dq8_backend_limit                          Limits the instruction set to `most`, one of enum dq8_backend
 *   dq8_set_reproducible                       Makes results the same on every machine, bit by bit
 *   dq8_fit                                    Finds the motion that brings `points` nearest to `moved`
 *   dq8_check_parents                          Checks that `parents` is a hierarchy
 *   dq8_pack                                   Packs plain poses into blocks
 *   dq8_unpack                                 Unpacks blocks into plain poses
 *   dq8_pack_chain                             Packs the links of a chain into blocks
 *   dq8_unpack_chain                           Unpacks the blocks of a chain into plain links
 *   dq8_block_size                             Returns the size of a block, counted in floats or doubles
 *   dq8_solutions_scratch                      Writes the size that `scratch` of dq8_solutions must have
 *   dq8_solutions                              Finds all solutions of an arm of six hinges for `count` targets
 *   dq8_status_text                            Returns the meaning of a status in English
 *   dq8_reach_scratch                          Writes the size that `scratch` of dq8_reach must have
 *   dq8_reach                                  Solves the inverse kinematics of `count` configurations
 *   dq8_resample                               Samples a trajectory at other times
 */

#ifndef DQ8_H
#define DQ8_H

#include <stddef.h>
#include <stdint.h>

/* The version of this header. */
#define DQ8_VERSION_MAJOR 0
#define DQ8_VERSION_MINOR 1
#define DQ8_VERSION_PATCH 0

/**
 * The result of a call. If it is not DQ8_STATUS_OK, the outputs are as they were. Exceptions
 * are an index such as `bad_joint` or `bad_vertex`, the steps of a mechanism that could not be
 * made, and scratch.
 */
enum dq8_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * The call has succeeded.
   */
  DQ8_STATUS_OK = 0,
  /**
   * A pointer is null, but its array has elements.
   */
  DQ8_STATUS_NULL_POINTER = 1,
  /**
   * A pointer is not aligned to its element type or, for blocks, to 64 bytes.
   */
  DQ8_STATUS_MISALIGNED = 2,
  /**
   * An output overlaps an input or another output. If a function allows an output to be one
   * of its inputs, the two must be exactly the same array.
   */
  DQ8_STATUS_OVERLAP = 3,
  /**
   * An array would be larger than memory.
   */
  DQ8_STATUS_TOO_LARGE = 4,
  /**
   * The arrays of `count` elements do not hold whole instances or configurations: `count`,
   * or `link_count`, is no multiple of the number of joints or links.
   */
  DQ8_STATUS_LENGTH = 5,
  /**
   * There are no blocks with this number of lanes. Blocks of float have 8 or 16 lanes, and
   * blocks of double 4 or 8.
   */
  DQ8_STATUS_LANES = 6,
  /**
   * The motion, or the placement of a joint, is not unit.
   */
  DQ8_STATUS_NOT_UNIT = 7,
  /**
   * The dual quaternion cannot be normalized, because its real part is zero or a component
   * is not finite.
   */
  DQ8_STATUS_NOT_NORMALIZABLE = 8,
  /**
   * The motion has no inverse, because its real part is zero or a component is not finite.
   */
  DQ8_STATUS_NO_INVERSE = 9,
  /**
   * The matrix is no rigid motion, because it scales or shears.
   */
  DQ8_STATUS_NOT_ORTHONORMAL = 10,
  /**
   * The matrix is no rigid motion, because it mirrors.
   */
  DQ8_STATUS_MIRRORS = 11,
  /**
   * An input that must be finite is not, such as the translation of a matrix or a field of a
   * joint.
   */
  DQ8_STATUS_NOT_FINITE = 12,
  /**
   * The last row of the 4x4 matrix is not 0 0 0 1.
   */
  DQ8_STATUS_NOT_AFFINE = 13,
  /**
   * There is nothing to blend or to fit, because the number of motions, influences or pairs
   * of points is 0, or all weights of pairs are 0.
   */
  DQ8_STATUS_NO_INFLUENCES = 14,
  /**
   * The parent of a joint does not come before it in the array.
   */
  DQ8_STATUS_PARENT_NOT_BEFORE = 15,
  /**
   * The parent of a joint is neither a joint nor -1.
   */
  DQ8_STATUS_PARENT_OUT_OF_RANGE = 16,
  /**
   * There are more joints than 32 bits can number.
   */
  DQ8_STATUS_TOO_MANY_JOINTS = 17,
  /**
   * An argument has no allowed value: it is no value of its enum (a backend, an order of
   * matrices, a kind of joint, a frame), no order of Euler angles, a damping that is
   * negative or not finite, neither 0 nor 1 where only these are allowed, or no index of a
   * clip.
   */
  DQ8_STATUS_UNKNOWN_VALUE = 18,
  /**
   * The length of an axis or normal is not 1.
   */
  DQ8_STATUS_AXIS = 19,
  /**
   * A joint cannot mimic its leader: there is no joint with the leader's index, the leader
   * mimics another joint, or one of the two joints does not have exactly one value.
   */
  DQ8_STATUS_MIMIC = 20,
  /**
   * The mechanism has no link with the given index.
   */
  DQ8_STATUS_NO_LINK = 21,
  /**
   * The mechanism is a zeroed struct that dq8_mechanism_make has not filled in.
   */
  DQ8_STATUS_NO_MECHANISM = 22,
  /**
   * A vertex follows a joint that the palette does not have.
   */
  DQ8_STATUS_JOINT_OUT_OF_RANGE = 23,
  /**
   * A weight is negative or not finite, or all weights of a goal are 0, or there is no goal.
   */
  DQ8_STATUS_WEIGHT = 24,
  /**
   * The weights of a vertex, which should sum to 1, sum to less than 1/1024 or more
   * than 1024.
   */
  DQ8_STATUS_WEIGHT_SUM = 25,
  /**
   * The skin is a zeroed struct that dq8_skin_make has not filled in.
   */
  DQ8_STATUS_NO_SKIN = 26,
  /**
   * The limits of a joint are not in order, or they allow no value together with the limits
   * of joints that mimic the joint, or they are angles so large that the element type cannot
   * resolve them.
   */
  DQ8_STATUS_LIMITS = 27,
  /**
   * A field of a vertex is not inside of the vertex, or overlaps another field.
   */
  DQ8_STATUS_FIELD = 28,
  /**
   * The order of a plan was made for other parents.
   */
  DQ8_STATUS_NO_PLAN = 29,
  /**
   * A share of a mix is not in [0, 1].
   */
  DQ8_STATUS_SHARE = 30,
  /**
   * The link of a goal cannot move, because only fixed joints carry it.
   */
  DQ8_STATUS_UNMOVED = 31,
  /**
   * The clips are a zeroed struct that dq8_clips_make has not filled in.
   */
  DQ8_STATUS_NO_CLIPS = 32,
  /**
   * The bytes are no packed clips.
   */
  DQ8_STATUS_NOT_CLIPS = 33,
  /**
   * A stamp of a trajectory is not later than the stamp before it, or is not finite.
   */
  DQ8_STATUS_TIMES = 34,
  /**
   * A time is before the first stamp or after the last stamp of a trajectory, and the
   * options refuse such times. Or the time at which `frame` is taken is not finite.
   */
  DQ8_STATUS_OUTSIDE = 35,
  /**
   * `value_count` is not the mechanism's number of values times the number of
   * configurations.
   */
  DQ8_STATUS_LENGTH_VALUES = 36,
  /**
   * `column_count` is not the mechanism's number of rates.
   */
  DQ8_STATUS_LENGTH_COLUMNS = 37,
  /**
   * `scratch_count` is less than the function whose name ends in `_scratch` has written.
   */
  DQ8_STATUS_LENGTH_SCRATCH = 38,
  /**
   * `pose_count` is no multiple of the number of joints.
   */
  DQ8_STATUS_LENGTH_POSES = 39,
  /**
   * `block_count` is not the number of blocks that the instances or links fill.
   */
  DQ8_STATUS_LENGTH_BLOCKS = 40,
  /**
   * `joint_count` is not the number of joints of the skin or of the clips.
   */
  DQ8_STATUS_LENGTH_JOINTS = 41,
  /**
   * `vertices` is not the number of vertices of the skin.
   */
  DQ8_STATUS_LENGTH_VERTICES = 42,
  /**
   * Only one of two vertex buffers has normals, or tangents.
   */
  DQ8_STATUS_FIELDS = 43,
  /**
   * There are fewer poses than are needed: one for a trajectory, two if its body is to go
   * on, and four control poses for a spline.
   */
  DQ8_STATUS_FEW_POSES = 44,
  /**
   * A place was found in other clips.
   */
  DQ8_STATUS_OTHER_CLIPS = 45,
  /**
   * The joints that carry the link of the goal are not six hinges with values of their own,
   * and fixed joints; or the goal leaves a part of the pose free.
   */
  DQ8_STATUS_NOT_SIX_HINGES = 46,
  /**
   * The packed clips are longer than `capacity`.
   */
  DQ8_STATUS_LENGTH_BYTES = 47,
  /**
   * The text is no URDF file that a mechanism can express.
   */
  DQ8_STATUS_URDF = 48,
  /**
   * `names_size` is not the size of the names.
   */
  DQ8_STATUS_LENGTH_NAMES = 49,
  /**
   * There is no clip, frame or joint to pack.
   */
  DQ8_STATUS_NO_FRAMES = 50,
  /**
   * Many rotations fit equally well, for instance because the points of one array are on a
   * line.
   */
  DQ8_STATUS_AMBIGUOUS = 51,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum dq8_status dq8_status;
#else
typedef int32_t dq8_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The instruction sets that functions of arrays and blocks may use, each with more instructions
 * than the previous set.
 */
enum dq8_backend
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * The instructions that the library was built for: SSE2 on x86-64, NEON on aarch64, no vectors
   * on a Cortex-M.
   */
  DQ8_BACKEND_PORTABLE = 0,
  /**
   * x86-64 with AVX2 and FMA.
   */
  DQ8_BACKEND_AVX2 = 1,
  /**
   * x86-64 with AVX-512 F, VL and DQ.
   */
  DQ8_BACKEND_AVX512 = 2,
  /**
   * No limit. Newer versions of the library may use instruction sets that this enum does not
   * have.
   */
  DQ8_BACKEND_ANY = 255,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum dq8_backend dq8_backend;
#else
typedef int32_t dq8_backend;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The order of the components of a matrix in memory.
 */
enum dq8_matrix_order
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * Row by row, as in C arrays.
   */
  DQ8_MATRIX_ORDER_ROWS = 0,
  /**
   * Column by column, as in OpenGL and in GPU buffers.
   */
  DQ8_MATRIX_ORDER_COLUMNS = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum dq8_matrix_order dq8_matrix_order;
#else
typedef int32_t dq8_matrix_order;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The kind of a joint: the motion that it makes in its own frame.
 */
enum dq8_joint_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * The joint does not move. It has no value.
   */
  DQ8_JOINT_KIND_FIXED = 0,
  /**
   * The joint turns about `axis`. It has one value, in radians.
   */
  DQ8_JOINT_KIND_REVOLUTE = 1,
  /**
   * The joint slides along `axis`. It has one value, a length.
   */
  DQ8_JOINT_KIND_PRISMATIC = 2,
  /**
   * The joint turns about `axis`, and slides along it by `pitch` for each radian. It has one
   * value, in radians.
   */
  DQ8_JOINT_KIND_SCREW = 3,
  /**
   * The joint slides in the plane at right angles to `axis`, then turns about `axis`. It has
   * three values: x, y and the angle in radians. The directions of x and y are the x and y axes
   * of the joint's frame after the shortest rotation that takes its z axis to `axis`.
   */
  DQ8_JOINT_KIND_PLANAR = 4,
  /**
   * The joint moves freely. It has seven values: a quaternion x y z w of any length but zero,
   * then a translation x y z. It has six rates, the body twist: angular x y z, then linear x y
   * z.
   */
  DQ8_JOINT_KIND_FLOATING = 5,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum dq8_joint_kind dq8_joint_kind;
#else
typedef int32_t dq8_joint_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The frame of the columns of a Jacobian. It decides along which axes the components are measured,
 * and for which point the linear velocity is given.
 */
enum dq8_frame
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * The axes of the base and the origin of the base: columns are spatial twists.
   */
  DQ8_FRAME_WORLD = 0,
  /**
   * The axes of the link and the origin of the link: columns are body twists.
   */
  DQ8_FRAME_BODY = 1,
  /**
   * The axes of the base and the origin of the link.
   */
  DQ8_FRAME_WORLD_ALIGNED = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum dq8_frame dq8_frame;
#else
typedef int32_t dq8_frame;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The outcome of a search for the values that bring links to their targets.
 */
enum dq8_outcome
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * All links are at their targets, within the tolerances.
   */
  DQ8_OUTCOME_CONVERGED = 0,
  /**
   * A target is farther away than the chain of joints that carries its link can reach.
   */
  DQ8_OUTCOME_OUT_OF_REACH = 1,
  /**
   * No step led nearer to the targets, and a joint is at its limit.
   */
  DQ8_OUTCOME_AT_LIMITS = 2,
  /**
   * No step led nearer to the targets.
   */
  DQ8_OUTCOME_STALLED = 3,
  /**
   * The search took all its iterations while the links still came nearer. More iterations would
   * help.
   */
  DQ8_OUTCOME_UNFINISHED = 4,
  /**
   * An input is invalid: a target is not unit within 0.001, an input is not finite, an option is
   * negative or NaN, or max_step is 0. The values are as they were.
   */
  DQ8_OUTCOME_INVALID = 5,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum dq8_outcome dq8_outcome;
#else
typedef int32_t dq8_outcome;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The frames of a clip, as dq8_clips_pack reads them.
 */
typedef struct dq8_frames {
  /**
   * Local poses `[frame][joint]`, of seven components each: a unit quaternion (x, y, z, w), then
   * a translation (x, y, z).
   */
  const float *keys;
  /**
   * The number of frames.
   */
  size_t count;
  /**
   * The number of frames a second, so that times are in seconds. 0 for times in frames.
   */
  double rate;
  /**
   * 1 if the clip begins again where it ends, and 0 otherwise.
   */
  uint32_t loops;
} dq8_frames;

/**
 * Packed clips of one skeleton, made by dq8_clips_make. This struct may be copied and moved. It
 * points to the bytes of the file, which must stay where they are and must not change.
 */
typedef struct dq8_clips {
  /**
   * The number of joints of the skeleton. It is 0 in a zeroed struct that dq8_clips_make has not
   * filled in.
   */
  size_t joints;
  /**
   * The number of clips.
   */
  size_t clips;
  /**
   * Private to the library.
   */
  const uint8_t *opaque[13];
} dq8_clips;

/**
 * A place in a clip: a frame, found by dq8_clips_place. It is valid for the same clips only.
 */
typedef struct dq8_place {
  /**
   * Private to the library.
   */
  uint32_t numbers[6];
} dq8_place;

/**
 * The quality of a fit, and how well the points determine a rotation.
 */
typedef struct dq8_fit_quality_f32 {
  /**
   * The factor by which the points are multiplied before they are moved. It is 1 unless `scaled`
   * was 1.
   */
  float scale;
  /**
   * The root mean square of the distances that the fit leaves, with the weights.
   */
  float rms;
  /**
   * The stiffness of the pairs against the turn that they resist most, over the stiffness
   * against the turn that they resist least. A large number means that noise turns the result.
   */
  float condition;
  /**
   * 3 for points in space, and 2 for points in a plane.
   */
  size_t rank;
  /**
   * 1 if the points are mirrored, so that one of the two arrays has left-handed coordinates: a
   * reflection would leave less than a hundredth of the squares that the fit leaves. Otherwise
   * 0.
   */
  int32_t mirrored;
} dq8_fit_quality_f32;

/**
 * The quality of a fit, and how well the points determine a rotation.
 */
typedef struct dq8_fit_quality_f64 {
  /**
   * The factor by which the points are multiplied before they are moved. It is 1 unless `scaled`
   * was 1.
   */
  double scale;
  /**
   * The root mean square of the distances that the fit leaves, with the weights.
   */
  double rms;
  /**
   * The stiffness of the pairs against the turn that they resist most, over the stiffness
   * against the turn that they resist least. A large number means that noise turns the result.
   */
  double condition;
  /**
   * 3 for points in space, and 2 for points in a plane.
   */
  size_t rank;
  /**
   * 1 if the points are mirrored, so that one of the two arrays has left-handed coordinates: a
   * reflection would leave less than a hundredth of the squares that the fit leaves. Otherwise
   * 0.
   */
  int32_t mirrored;
} dq8_fit_quality_f64;

/**
 * The memory that a mechanism needs for one joint. Its content is private to the library.
 */
typedef struct dq8_step_f32 {
  /**
   * Private to the library.
   */
  float opaque[100];
} dq8_step_f32;

/**
 * A mechanism, made by dq8_mechanism_make. This struct may be copied and moved. It points to its
 * steps, which must stay where they are and must not change.
 */
typedef struct dq8_mechanism_f32 {
  /**
   * The number of links, one for each joint.
   */
  size_t links;
  /**
   * The number of values of a configuration. A configuration holds the values of joint 0, then
   * the values of joint 1, and so on.
   */
  size_t values;
  /**
   * The number of rates, which is the number of columns of a Jacobian. Each joint has as many
   * rates as values, except that a floating joint has seven values and six rates.
   */
  size_t rates;
  /**
   * The array of steps. It is null in a zeroed struct that dq8_mechanism_make has not filled in.
   */
  const struct dq8_step_f32 *steps;
  /**
   * Private to the library.
   */
  const struct dq8_step_f32 *opaque[4];
} dq8_mechanism_f32;

/**
 * The memory that a mechanism needs for one joint. Its content is private to the library.
 */
typedef struct dq8_step_f64 {
  /**
   * Private to the library.
   */
  double opaque[100];
} dq8_step_f64;

/**
 * A mechanism, made by dq8_mechanism_make. This struct may be copied and moved. It points to its
 * steps, which must stay where they are and must not change.
 */
typedef struct dq8_mechanism_f64 {
  /**
   * The number of links, one for each joint.
   */
  size_t links;
  /**
   * The number of values of a configuration. A configuration holds the values of joint 0, then
   * the values of joint 1, and so on.
   */
  size_t values;
  /**
   * The number of rates, which is the number of columns of a Jacobian. Each joint has as many
   * rates as values, except that a floating joint has seven values and six rates.
   */
  size_t rates;
  /**
   * The array of steps. It is null in a zeroed struct that dq8_mechanism_make has not filled in.
   */
  const struct dq8_step_f64 *steps;
  /**
   * Private to the library.
   */
  const struct dq8_step_f64 *opaque[4];
} dq8_mechanism_f64;

/**
 * The joint between a link and its parent link. The joint with index j carries the link with index
 * j.
 *
 * The fields `axis` and `pitch` are read only for kinds of joints that have an axis or a pitch.
 * For other kinds they may be 0.
 */
typedef struct dq8_joint_f32 {
  /**
   * The index of the parent link, which must be less than the index of this link, or -1 for the
   * base.
   */
  int32_t parent;
  /**
   * The kind, one of enum dq8_joint_kind.
   */
  int32_t kind;
  /**
   * The pose of the link in its parent link when the values of the joint are zero. It must be a
   * motion that is unit within 0.001.
   */
  float placement[8];
  /**
   * The axis of the joint, or the normal of a planar joint. Its length must be 1 within 0.001.
   */
  float axis[3];
  /**
   * The length that a screw slides per radian: the lead of its thread over 2 pi.
   */
  float pitch;
  /**
   * 1 if the joint has no value of its own and mimics joint `leader`: it moves as if its value
   * were `multiplier` times the value of the leader plus `offset`. Otherwise 0. Both joints must
   * be of kinds with one value, and the leader must not mimic another joint.
   */
  int32_t mimics;
  /**
   * The index of the joint whose value this joint takes, if `mimics` is 1.
   */
  int32_t leader;
  /**
   * The factor of the leader's value, if `mimics` is 1.
   */
  float multiplier;
  /**
   * The value that is added to the product, if `mimics` is 1.
   */
  float offset;
  /**
   * 1 if the joint has limits, otherwise 0. Only a joint with one value can have limits. Inverse
   * kinematics keeps to the limits, and all other functions ignore them.
   */
  int32_t limited;
  /**
   * The smallest and the largest value of the joint, if `limited` is 1. Either may be infinite.
   */
  float limits[2];
} dq8_joint_f32;

/**
 * The joint between a link and its parent link. The joint with index j carries the link with index
 * j.
 *
 * The fields `axis` and `pitch` are read only for kinds of joints that have an axis or a pitch.
 * For other kinds they may be 0.
 */
typedef struct dq8_joint_f64 {
  /**
   * The index of the parent link, which must be less than the index of this link, or -1 for the
   * base.
   */
  int32_t parent;
  /**
   * The kind, one of enum dq8_joint_kind.
   */
  int32_t kind;
  /**
   * The pose of the link in its parent link when the values of the joint are zero. It must be a
   * motion that is unit within 0.001.
   */
  double placement[8];
  /**
   * The axis of the joint, or the normal of a planar joint. Its length must be 1 within 0.001.
   */
  double axis[3];
  /**
   * The length that a screw slides per radian: the lead of its thread over 2 pi.
   */
  double pitch;
  /**
   * 1 if the joint has no value of its own and mimics joint `leader`: it moves as if its value
   * were `multiplier` times the value of the leader plus `offset`. Otherwise 0. Both joints must
   * be of kinds with one value, and the leader must not mimic another joint.
   */
  int32_t mimics;
  /**
   * The index of the joint whose value this joint takes, if `mimics` is 1.
   */
  int32_t leader;
  /**
   * The factor of the leader's value, if `mimics` is 1.
   */
  double multiplier;
  /**
   * The value that is added to the product, if `mimics` is 1.
   */
  double offset;
  /**
   * 1 if the joint has limits, otherwise 0. Only a joint with one value can have limits. Inverse
   * kinematics keeps to the limits, and all other functions ignore them.
   */
  int32_t limited;
  /**
   * The smallest and the largest value of the joint, if `limited` is 1. Either may be infinite.
   */
  double limits[2];
} dq8_joint_f64;

/**
 * The options of a search. dq8_mechanism_reach_options fills in the defaults.
 */
typedef struct dq8_reach_options_f32 {
  /**
   * The largest angle in radians between a link and its target at which the search has
   * converged.
   */
  float angular_tolerance;
  /**
   * The largest distance between a link and its target at which the search has converged.
   */
  float linear_tolerance;
  /**
   * The largest number of iterations. Steps and restarts both count as iterations.
   */
  uint32_t max_iterations;
  /**
   * 1 to begin again from another configuration when the search gets stuck. 0 to search from the
   * given values only, which suits a target that moves and is followed.
   */
  uint32_t restarts;
  /**
   * The error in distance that weighs as much as an error of one radian. 0 stands for an eighth
   * of the mechanism's length. If a joint floats or slides without limits, that length is at
   * least the distance from the base to the farthest target, and at least the largest slide in
   * the given values.
   */
  float length_per_radian;
  /**
   * The largest angle in radians by which a joint turns in one step. A value of more than a full
   * turn counts as a full turn.
   */
  float max_step;
  /**
   * The damping of steps at the target itself, in radians. It keeps steps short near singular
   * poses. With 0, the search converges fastest.
   */
  float damping;
} dq8_reach_options_f32;

/**
 * A goal of inverse kinematics: a link that is to come to its target, and the weights of the six
 * components of its error, in the axes of the target. A component with the weight 0 is free. The
 * sizes of the other weights matter only if the components cannot all become zero.
 */
typedef struct dq8_goal_f32 {
  /**
   * The index of the link.
   */
  size_t link;
  /**
   * The weights of the rotation about the target's axes x, y and z. They must not be negative.
   */
  float angular[3];
  /**
   * The weights of the distance along the target's axes x, y and z. They must not be negative.
   */
  float linear[3];
  /**
   * The point of the link that is to be at the target, in the frame of the link. Zero is the
   * origin of the link.
   */
  float point[3];
} dq8_goal_f32;

/**
 * The report of a search. Its errors are those of the values that the search returns.
 */
typedef struct dq8_reach_report_f32 {
  /**
   * The outcome, one of enum dq8_outcome.
   */
  int32_t outcome;
  /**
   * The number of iterations. Steps and restarts both count as iterations.
   */
  uint32_t iterations;
  /**
   * The number of restarts.
   */
  uint32_t restarts;
  /**
   * The largest angle in radians between a link and its target. Components with weight 0 do not
   * count.
   */
  float angular_error;
  /**
   * The largest distance between a link and its target. Components with weight 0 do not count.
   */
  float linear_error;
} dq8_reach_report_f32;

/**
 * The options of a search. dq8_mechanism_reach_options fills in the defaults.
 */
typedef struct dq8_reach_options_f64 {
  /**
   * The largest angle in radians between a link and its target at which the search has
   * converged.
   */
  double angular_tolerance;
  /**
   * The largest distance between a link and its target at which the search has converged.
   */
  double linear_tolerance;
  /**
   * The largest number of iterations. Steps and restarts both count as iterations.
   */
  uint32_t max_iterations;
  /**
   * 1 to begin again from another configuration when the search gets stuck. 0 to search from the
   * given values only, which suits a target that moves and is followed.
   */
  uint32_t restarts;
  /**
   * The error in distance that weighs as much as an error of one radian. 0 stands for an eighth
   * of the mechanism's length. If a joint floats or slides without limits, that length is at
   * least the distance from the base to the farthest target, and at least the largest slide in
   * the given values.
   */
  double length_per_radian;
  /**
   * The largest angle in radians by which a joint turns in one step. A value of more than a full
   * turn counts as a full turn.
   */
  double max_step;
  /**
   * The damping of steps at the target itself, in radians. It keeps steps short near singular
   * poses. With 0, the search converges fastest.
   */
  double damping;
} dq8_reach_options_f64;

/**
 * A goal of inverse kinematics: a link that is to come to its target, and the weights of the six
 * components of its error, in the axes of the target. A component with the weight 0 is free. The
 * sizes of the other weights matter only if the components cannot all become zero.
 */
typedef struct dq8_goal_f64 {
  /**
   * The index of the link.
   */
  size_t link;
  /**
   * The weights of the rotation about the target's axes x, y and z. They must not be negative.
   */
  double angular[3];
  /**
   * The weights of the distance along the target's axes x, y and z. They must not be negative.
   */
  double linear[3];
  /**
   * The point of the link that is to be at the target, in the frame of the link. Zero is the
   * origin of the link.
   */
  double point[3];
} dq8_goal_f64;

/**
 * The report of a search. Its errors are those of the values that the search returns.
 */
typedef struct dq8_reach_report_f64 {
  /**
   * The outcome, one of enum dq8_outcome.
   */
  int32_t outcome;
  /**
   * The number of iterations. Steps and restarts both count as iterations.
   */
  uint32_t iterations;
  /**
   * The number of restarts.
   */
  uint32_t restarts;
  /**
   * The largest angle in radians between a link and its target. Components with weight 0 do not
   * count.
   */
  double angular_error;
  /**
   * The largest distance between a link and its target. Components with weight 0 do not count.
   */
  double linear_error;
} dq8_reach_report_f64;

/**
 * The joints and weights that move the vertices of a mesh, made by dq8_skin_make. This struct may
 * be copied and moved. It points to the arrays of joint indices and weights, which must stay where
 * they are and must not change.
 */
typedef struct dq8_skin_f32 {
  /**
   * The number of vertices of the mesh.
   */
  size_t vertices;
  /**
   * The number of influences of each vertex, which are its joints with their weights. It is 0 in
   * a zeroed struct that dq8_skin_make has not filled in.
   */
  size_t influences;
  /**
   * The number of joints, which is the number of entries of a palette.
   */
  size_t joints;
  /**
   * Private to the library.
   */
  const float *opaque[8];
} dq8_skin_f32;

/**
 * The layout of the joint indices, or of the weights, in an array that holds one vertex after the
 * other. Both fields of this struct count elements of the array, not bytes.
 */
typedef struct dq8_influence_field {
  /**
   * The distance from the beginning of a vertex to the beginning of the next vertex.
   */
  size_t stride;
  /**
   * The offset of the first joint index, or of the first weight, in a vertex.
   */
  size_t first;
} dq8_influence_field;

/**
 * The layout of a vertex buffer, which holds one vertex after the other. All fields of this struct
 * count elements, that is, floats or doubles, and not bytes. A position, a normal or a tangent has
 * three components.
 */
typedef struct dq8_vertex_fields {
  /**
   * The distance from the beginning of a vertex to the beginning of the next vertex.
   */
  size_t stride;
  /**
   * The offset of the position in a vertex.
   */
  int32_t position;
  /**
   * The offset of the normal in a vertex, or -1 to pose no normals.
   */
  int32_t normal;
  /**
   * The offset of the tangent in a vertex, or -1 to pose no tangents. A fourth component, the
   * sign of the bitangent, does not belong to the tangent and is not written.
   */
  int32_t tangent;
} dq8_vertex_fields;

/**
 * The joints and weights that move the vertices of a mesh, made by dq8_skin_make. This struct may
 * be copied and moved. It points to the arrays of joint indices and weights, which must stay where
 * they are and must not change.
 */
typedef struct dq8_skin_f64 {
  /**
   * The number of vertices of the mesh.
   */
  size_t vertices;
  /**
   * The number of influences of each vertex, which are its joints with their weights. It is 0 in
   * a zeroed struct that dq8_skin_make has not filled in.
   */
  size_t influences;
  /**
   * The number of joints, which is the number of entries of a palette.
   */
  size_t joints;
  /**
   * Private to the library.
   */
  const double *opaque[8];
} dq8_skin_f64;

/**
 * A solution: values of the six hinges that bring the link of the goal to the target. The last
 * three fields are 1 if the arm is singular there, and 0 otherwise.
 */
typedef struct dq8_solution_f32 {
  /**
   * The values of the six hinges from the base up, within their limits, and as near to the start
   * as whole turns allow.
   */
  float values[6];
  /**
   * The distance from the start in radians: the root of the sum of the squared differences.
   */
  float distance;
  /**
   * 1 if the wrist is on the first axis, or as far from the plane of the arm as it can be.
   */
  uint8_t shoulder;
  /**
   * 1 if the arm is stretched or folded at the second and third axis.
   */
  uint8_t elbow;
  /**
   * 1 if the last axis is parallel to one before it.
   */
  uint8_t wrist;
} dq8_solution_f32;

/**
 * All solutions for a target.
 */
typedef struct dq8_solution_list_f32 {
  /**
   * The solutions, the nearest to the start first. Elements from `count` on have no meaning.
   */
  struct dq8_solution_f32 all[8];
  /**
   * The number of solutions. It is 0 if the target cannot be reached.
   */
  size_t count;
  /**
   * 1 if the arm has no other solutions, and 0 if searches have found these, so that there may
   * be more.
   */
  uint8_t is_complete;
} dq8_solution_list_f32;

/**
 * A solution: values of the six hinges that bring the link of the goal to the target. The last
 * three fields are 1 if the arm is singular there, and 0 otherwise.
 */
typedef struct dq8_solution_f64 {
  /**
   * The values of the six hinges from the base up, within their limits, and as near to the start
   * as whole turns allow.
   */
  double values[6];
  /**
   * The distance from the start in radians: the root of the sum of the squared differences.
   */
  double distance;
  /**
   * 1 if the wrist is on the first axis, or as far from the plane of the arm as it can be.
   */
  uint8_t shoulder;
  /**
   * 1 if the arm is stretched or folded at the second and third axis.
   */
  uint8_t elbow;
  /**
   * 1 if the last axis is parallel to one before it.
   */
  uint8_t wrist;
} dq8_solution_f64;

/**
 * All solutions for a target.
 */
typedef struct dq8_solution_list_f64 {
  /**
   * The solutions, the nearest to the start first. Elements from `count` on have no meaning.
   */
  struct dq8_solution_f64 all[8];
  /**
   * The number of solutions. It is 0 if the target cannot be reached.
   */
  size_t count;
  /**
   * 1 if the arm has no other solutions, and 0 if searches have found these, so that there may
   * be more.
   */
  uint8_t is_complete;
} dq8_solution_list_f64;

/**
 * The options of a trajectory: the clock of the times, the poses outside of the stamps, and the
 * frame of the results.
 */
typedef struct dq8_trajectory_options {
  /**
   * The stamp, in seconds, of the time 0. A time t is at the stamp origin + unit * t. It is 0 if
   * times are on the clock of the stamps.
   */
  double origin;
  /**
   * The seconds in one unit of the times: 1 for times in seconds, and 1e-9 for nanoseconds.
   */
  double unit;
  /**
   * The pose before the first stamp and after the last stamp. 0: the moving body stands still at
   * the first or last pose. 1: it goes on as it moves between the first two or the last two
   * poses. 2: a time before the first or after the last stamp is an error.
   */
  int32_t outside;
  /**
   * The frame of the results. 0: the world. 1: the frame of the moving body at the first stamp.
   * 2: its frame at the last stamp. 3: its frame at `time`. 4: a frame whose pose in the world
   * is `pose`.
   */
  int32_t frame;
  /**
   * The time whose pose is the frame, if `frame` is 3: in seconds, on the same clock as the
   * stamps of the trajectory.
   */
  double time;
  /**
   * If `frame` is 4, the pose of the frame in the world, a unit motion.
   */
  double pose[8];
} dq8_trajectory_options;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * Returns the name of the instruction set in use, for logs. The text lives as long as the program.
 */
const char *dq8_backend_name(void);

/**
 * Limits the instruction set to `most`, one of enum dq8_backend. The limit holds in all threads
 * and from now on. Instructions that the CPU does not have are never used, so every limit is safe.
 *
 * Returns DQ8_STATUS_UNKNOWN_VALUE if `most` is no value of enum dq8_backend. The limit then stays
 * as it was.
 */
dq8_status dq8_backend_limit(int32_t most);

/**
 * Makes results the same on every machine, bit by bit. This concerns functions of arrays and
 * blocks, in all threads and from now on. The value 1 of `reproducible` switches this on, and
 * functions then take 1.0 to 1.5 times as long. The value 0 switches it off, which is the state
 * when the program starts. The limit of dq8_backend_limit holds in both states. Functions of one
 * motion have the same bits on every machine in either state.
 *
 * Returns DQ8_STATUS_UNKNOWN_VALUE if `reproducible` is neither 0 nor 1, or if it is 1 and the
 * library was built without the feature `reproducible`; nothing changes then.
 */
dq8_status dq8_set_reproducible(int32_t reproducible);

/**
 * Computes `out[i] = links[0] * links[1] * ... * links[i]`, the model poses of a
 * chain. `links` and `out` hold `count` motions. This is faster than a loop if the
 * chain has dozens of links. Blocks hold one chain, with a segment of it in each lane,
 * as dq8_pack_chain writes them. `out` may be `links`.
 */
dq8_status dq8_chain_products_f32(const float *links, float *out, size_t count);

/**
 * Does what dq8_chain_products_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_chain_products_f32(size_t lanes,
                                         const float *links,
                                         float *out,
                                         size_t count);

/**
 * Computes `out[i] = links[0] * links[1] * ... * links[i]`, the model poses of a
 * chain. `links` and `out` hold `count` motions. This is faster than a loop if the
 * chain has dozens of links. Blocks hold one chain, with a segment of it in each lane,
 * as dq8_pack_chain writes them. `out` may be `links`.
 */
dq8_status dq8_chain_products_f64(const double *links, double *out, size_t count);

/**
 * Does what dq8_chain_products_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_chain_products_f64(size_t lanes,
                                         const double *links,
                                         double *out,
                                         size_t count);

/**
 * Writes a number of bytes that the file of these clips does not exceed, to `bound`. A program
 * that gives dq8_clips_pack so much memory need not call it twice. The arguments are those of
 * dq8_clips_pack, and so are the errors, except that translations are not looked at.
 */
dq8_status dq8_clips_bound(const struct dq8_frames *clips,
                           size_t clip_count,
                           size_t joint_count,
                           size_t *bound,
                           size_t *bad_key);

/**
 * Packs clips of one skeleton into a file, which dq8_clips_make reads. `clips` holds `clip_count`
 * clips of `joint_count` joints. The file takes about a quarter of the memory of the frames. A
 * rotation is off by at most 5.4e-5 radians, and each coordinate of a translation by at most
 * 1/131068 of the longest side of the box in which its joint moves in all clips, and by the
 * rounding of floats.
 *
 * The rotations of a joint in a clip that are all within `angle` radians of the first are kept as
 * the first alone, and its translations that are all within `length_tolerance` of the first along
 * each axis likewise, so they are off by up to this limit more: 2e-5 and 1e-5 suit metres.
 * `bytes` has room for `capacity` bytes, and `length` gets the length of the file. If `capacity`
 * is 0, only `length` is written. dq8_clips_bound tells enough room for less time.
 *
 * Returns DQ8_STATUS_LENGTH_BYTES if the file is longer than `capacity`, DQ8_STATUS_NO_FRAMES
 * if there is no clip, frame or joint, and DQ8_STATUS_UNKNOWN_VALUE for a wrong rate or `loops`.
 * Returns DQ8_STATUS_NOT_UNIT or _NOT_FINITE for a wrong local pose, and sets `bad_key`, which may
 * be null, to its index, counted through all clips.
 */
dq8_status dq8_clips_pack(const struct dq8_frames *clips,
                          size_t clip_count,
                          size_t joint_count,
                          float angle,
                          float length_tolerance,
                          uint8_t *bytes,
                          size_t capacity,
                          size_t *length,
                          size_t *bad_key);

/**
 * Makes `clips` from the `length` bytes of a packed clip file. dq8_clips_pack, the Rust
 * package and the Python package write such files. The function reads and checks all bytes once,
 * and copies none.
 *
 * Returns DQ8_STATUS_NOT_CLIPS if the bytes are no packed clips. It then sets `bad_offset`, which
 * may be null, to the offset of the first wrong byte.
 */
dq8_status dq8_clips_make(const uint8_t *bytes,
                          size_t length,
                          struct dq8_clips *clips,
                          size_t *bad_offset);

/**
 * Writes the time from the first to the last frame of a clip. The time is in seconds if the clip
 * has a rate, and in frames otherwise. `clip` is the index of the clip. Returns
 * DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
 */
dq8_status dq8_clips_duration(const struct dq8_clips *clips, size_t clip, double *duration);

/**
 * Finds the time `at` in a clip. It writes the frame before this time to `place`, and
 * to `t` the fraction of the way from this frame to the next frame, from 0 to 1. Times
 * are in seconds if the clip has a rate, and in frames otherwise. A time before the
 * first frame counts as the first frame, and a time after the last frame as the last
 * frame, unless the clip loops. Returns DQ8_STATUS_UNKNOWN_VALUE if there is no such
 * clip, and DQ8_STATUS_NOT_FINITE if `at` is NaN, or infinite in a clip that loops.
 */
dq8_status dq8_clips_place_f32(const struct dq8_clips *clips,
                               size_t clip,
                               float at,
                               struct dq8_place *place,
                               float *t);

/**
 * Computes the model poses of instances that play packed clips. The local poses of
 * instance i are at the fraction `t[i]` of the way from the frame `places[i]` to the
 * next frame. `t` is clamped to [0, 1], and NaN gives model poses of NaN. `parents`
 * and `root` are those of dq8_local_to_model. `models` is `[instance][joint]` and
 * holds `joint_count` times `instances` motions. Returns DQ8_STATUS_LENGTH_JOINTS if
 * the clips do not have `joint_count` joints, and DQ8_STATUS_OTHER_CLIPS if a place
 * belongs to other clips.
 */
dq8_status dq8_clips_to_model_f32(const int32_t *parents,
                                  size_t joint_count,
                                  const float *root,
                                  const struct dq8_clips *clips,
                                  const struct dq8_place *places,
                                  const float *t,
                                  size_t instances,
                                  float *models);

/**
 * Finds the time `at` in a clip. It writes the frame before this time to `place`, and
 * to `t` the fraction of the way from this frame to the next frame, from 0 to 1. Times
 * are in seconds if the clip has a rate, and in frames otherwise. A time before the
 * first frame counts as the first frame, and a time after the last frame as the last
 * frame, unless the clip loops. Returns DQ8_STATUS_UNKNOWN_VALUE if there is no such
 * clip, and DQ8_STATUS_NOT_FINITE if `at` is NaN, or infinite in a clip that loops.
 */
dq8_status dq8_clips_place_f64(const struct dq8_clips *clips,
                               size_t clip,
                               double at,
                               struct dq8_place *place,
                               double *t);

/**
 * Computes the model poses of instances that play packed clips. The local poses of
 * instance i are at the fraction `t[i]` of the way from the frame `places[i]` to the
 * next frame. `t` is clamped to [0, 1], and NaN gives model poses of NaN. `parents`
 * and `root` are those of dq8_local_to_model. `models` is `[instance][joint]` and
 * holds `joint_count` times `instances` motions. Returns DQ8_STATUS_LENGTH_JOINTS if
 * the clips do not have `joint_count` joints, and DQ8_STATUS_OTHER_CLIPS if a place
 * belongs to other clips.
 */
dq8_status dq8_clips_to_model_f64(const int32_t *parents,
                                  size_t joint_count,
                                  const double *root,
                                  const struct dq8_clips *clips,
                                  const struct dq8_place *places,
                                  const double *t,
                                  size_t instances,
                                  double *models);

/**
 * Makes the rotation about the origin of three turns about coordinate axes, the first
 * turn first. `angles` holds three angles in radians. `order` is a string of three
 * letters, the axis of the first turn first, and no axis twice in a row. Small letters
 * such as "xyz" are axes that stay fixed, and capitals such as "ZYX" are axes that
 * turn with the body. Returns DQ8_STATUS_UNKNOWN_VALUE for any other string.
 */
dq8_status dq8_motion_from_euler_f32(const char *order, const float *angles, float *out);

/**
 * Writes the three Euler angles of the rotation of a unit motion, in radians, in the
 * `order` of dq8_motion_from_euler. The middle angle is from -pi/2 to pi/2 if the
 * three axes differ, and otherwise from 0 to pi. `gimbal_lock`, which may be null, is
 * set to 1 if the first and the last axis coincide, so that other angles give the same
 * rotation, and otherwise to 0. The last angle is then 0.
 */
dq8_status dq8_motion_to_euler_f32(const float *motion,
                                   const char *order,
                                   float *angles,
                                   int32_t *gimbal_lock);

/**
 * Makes the rotation about the origin of three turns about coordinate axes, the first
 * turn first. `angles` holds three angles in radians. `order` is a string of three
 * letters, the axis of the first turn first, and no axis twice in a row. Small letters
 * such as "xyz" are axes that stay fixed, and capitals such as "ZYX" are axes that
 * turn with the body. Returns DQ8_STATUS_UNKNOWN_VALUE for any other string.
 */
dq8_status dq8_motion_from_euler_f64(const char *order, const double *angles, double *out);

/**
 * Writes the three Euler angles of the rotation of a unit motion, in radians, in the
 * `order` of dq8_motion_from_euler. The middle angle is from -pi/2 to pi/2 if the
 * three axes differ, and otherwise from 0 to pi. `gimbal_lock`, which may be null, is
 * set to 1 if the first and the last axis coincide, so that other angles give the same
 * rotation, and otherwise to 0. The last angle is then 0.
 */
dq8_status dq8_motion_to_euler_f64(const double *motion,
                                   const char *order,
                                   double *angles,
                                   int32_t *gimbal_lock);

/**
 * Finds the motion that brings `points` nearest to `moved`: the sum of the squared
 * distances, each multiplied by its weight, is least. Both arrays have `count` points
 * of three components. `weights` may be null for equal weights. If `scaled` is 1, the
 * points are first multiplied by the scale that fits best, and if it is 0 they are
 * not. `quality`, which may be null, gets the scale and tells how well the motion
 * fits; check its field `mirrored` if the handedness of the points is not known.
 *
 * Returns DQ8_STATUS_AMBIGUOUS if many rotations fit equally well, as for points on a
 * line, and DQ8_STATUS_NO_INFLUENCES if no pair has a weight. Returns
 * DQ8_STATUS_NOT_FINITE or _WEIGHT for a wrong point or weight, and sets `bad_pair`,
 * which may be null, to its index. DQ8_STATUS_NOT_FINITE also means that the points
 * are so far apart that a square overflows; `bad_pair` is then as it was.
 */
dq8_status dq8_fit_f32(const float *points,
                       const float *moved,
                       const float *weights,
                       size_t count,
                       int32_t scaled,
                       float *motion,
                       struct dq8_fit_quality_f32 *quality,
                       size_t *bad_pair);

/**
 * Finds the motion that brings `points` nearest to `moved`: the sum of the squared
 * distances, each multiplied by its weight, is least. Both arrays have `count` points
 * of three components. `weights` may be null for equal weights. If `scaled` is 1, the
 * points are first multiplied by the scale that fits best, and if it is 0 they are
 * not. `quality`, which may be null, gets the scale and tells how well the motion
 * fits; check its field `mirrored` if the handedness of the points is not known.
 *
 * Returns DQ8_STATUS_AMBIGUOUS if many rotations fit equally well, as for points on a
 * line, and DQ8_STATUS_NO_INFLUENCES if no pair has a weight. Returns
 * DQ8_STATUS_NOT_FINITE or _WEIGHT for a wrong point or weight, and sets `bad_pair`,
 * which may be null, to its index. DQ8_STATUS_NOT_FINITE also means that the points
 * are so far apart that a square overflows; `bad_pair` is then as it was.
 */
dq8_status dq8_fit_f64(const double *points,
                       const double *moved,
                       const double *weights,
                       size_t count,
                       int32_t scaled,
                       double *motion,
                       struct dq8_fit_quality_f64 *quality,
                       size_t *bad_pair);

/**
 * Moves a line by a unit motion. A line is given by its six Plücker coordinates: the
 * direction x y z, then the moment x y z, which is the cross product of any point on
 * the line and the direction.
 */
dq8_status dq8_motion_line_f32(const float *motion, const float *line, float *out);

/**
 * Moves a plane by a unit motion. A plane is given by four values: its unit normal x y
 * z, then the dot product of the normal and any point on the plane.
 */
dq8_status dq8_motion_plane_f32(const float *motion, const float *plane, float *out);

/**
 * Applies the adjoint of a unit motion to a twist, which turns a body twist into the
 * spatial twist. A twist has six components: angular x y z, then linear x y z.
 */
dq8_status dq8_motion_twist_f32(const float *motion, const float *twist, float *out);

/**
 * Writes the constant twist that moves the identity to a unit motion in one second. A
 * twist has six components: angular x y z, then linear x y z.
 */
dq8_status dq8_motion_to_twist_f32(const float *motion, float *twist);

/**
 * Moves a unit motion on by a constant body twist for `dt` seconds. A twist has six
 * components: angular x y z in radians per second, then linear x y z.
 */
dq8_status dq8_motion_integrate_body_f32(const float *motion,
                                         const float *twist,
                                         float dt,
                                         float *out);

/**
 * Writes the angle between two unit motions, in radians from 0 to pi.
 */
dq8_status dq8_motion_angle_to_f32(const float *a, const float *b, float *angle);

/**
 * Writes the distance between the translations of two unit motions.
 */
dq8_status dq8_motion_distance_to_f32(const float *a, const float *b, float *distance);

/**
 * Moves a line by a unit motion. A line is given by its six Plücker coordinates: the
 * direction x y z, then the moment x y z, which is the cross product of any point on
 * the line and the direction.
 */
dq8_status dq8_motion_line_f64(const double *motion, const double *line, double *out);

/**
 * Moves a plane by a unit motion. A plane is given by four values: its unit normal x y
 * z, then the dot product of the normal and any point on the plane.
 */
dq8_status dq8_motion_plane_f64(const double *motion, const double *plane, double *out);

/**
 * Applies the adjoint of a unit motion to a twist, which turns a body twist into the
 * spatial twist. A twist has six components: angular x y z, then linear x y z.
 */
dq8_status dq8_motion_twist_f64(const double *motion, const double *twist, double *out);

/**
 * Writes the constant twist that moves the identity to a unit motion in one second. A
 * twist has six components: angular x y z, then linear x y z.
 */
dq8_status dq8_motion_to_twist_f64(const double *motion, double *twist);

/**
 * Moves a unit motion on by a constant body twist for `dt` seconds. A twist has six
 * components: angular x y z in radians per second, then linear x y z.
 */
dq8_status dq8_motion_integrate_body_f64(const double *motion,
                                         const double *twist,
                                         double dt,
                                         double *out);

/**
 * Writes the angle between two unit motions, in radians from 0 to pi.
 */
dq8_status dq8_motion_angle_to_f64(const double *a, const double *b, double *angle);

/**
 * Writes the distance between the translations of two unit motions.
 */
dq8_status dq8_motion_distance_to_f64(const double *a, const double *b, double *distance);

/**
 * Checks that `parents` is a hierarchy: `parents[j]`, the parent of joint j, is less than j, or
 * -1. Every function that takes parents makes the same check, which costs little beside its work.
 * This function also tells which joint is wrong.
 *
 * Returns DQ8_STATUS_PARENT_NOT_BEFORE or _PARENT_OUT_OF_RANGE for the first joint whose parent is
 * wrong, and sets `bad_joint` to the index of this joint. `bad_joint` may be null, and must not
 * point into `parents`.
 */
dq8_status dq8_check_parents(const int32_t *parents, size_t joints, size_t *bad_joint);

/**
 * Computes model poses from local poses: `models[j] = models[parents[j]] * locals[j]`.
 *
 * `parents` holds `joints` indices of parents, or -1 for a joint without a parent.
 * `root` is a motion that moves all joints without a parent, or null. `locals` and
 * `models` are `[instance][joint]` and hold `count` motions: `joints` times the number
 * of instances. In blocks they are `[block of instances][joint]`, and `count` is
 * `joints` times the number of blocks of instances: the number of instances over
 * `lanes`, rounded up. `models` may be `locals`. Returns DQ8_STATUS_LENGTH if `count`
 * is no multiple of `joints`.
 */
dq8_status dq8_local_to_model_f32(const int32_t *parents,
                                  size_t joints,
                                  const float *root,
                                  const float *locals,
                                  float *models,
                                  size_t count);

/**
 * Does what dq8_local_to_model_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_local_to_model_f32(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const float *root,
                                         const float *locals,
                                         float *models,
                                         size_t count);

/**
 * Computes local poses from unit model poses. This is the inverse of
 * dq8_local_to_model, and the arrays have the same shapes. `locals` may be `models`.
 */
dq8_status dq8_model_to_local_f32(const int32_t *parents,
                                  size_t joints,
                                  const float *root,
                                  const float *models,
                                  float *locals,
                                  size_t count);

/**
 * Does what dq8_model_to_local_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_model_to_local_f32(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const float *root,
                                         const float *models,
                                         float *locals,
                                         size_t count);

/**
 * Computes model poses from rotations and fixed offsets. Animation clips often hold
 * local poses in this form. `rotations` holds `count` unit quaternions (x, y, z, w).
 * `offsets` holds `joints` translations (x, y, z): the position of each joint in its
 * parent, which is the same in all instances. Other arguments and errors are those of
 * dq8_local_to_model.
 */
dq8_status dq8_rotations_to_model_f32(const int32_t *parents,
                                      size_t joints,
                                      const float *root,
                                      const float *rotations,
                                      const float *offsets,
                                      float *models,
                                      size_t count);

/**
 * Does what dq8_rotations_to_model_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_rotations_to_model_f32(size_t lanes,
                                             const int32_t *parents,
                                             size_t joints,
                                             const float *root,
                                             const float *rotations,
                                             const float *offsets,
                                             float *models,
                                             size_t count);

/**
 * Computes model poses from rotations and translations. `locals` holds `count` local
 * poses of seven components: a unit quaternion (x, y, z, w), then a translation (x, y,
 * z). Other arguments and errors are those of dq8_local_to_model.
 */
dq8_status dq8_rotations_translations_to_model_f32(const int32_t *parents,
                                                   size_t joints,
                                                   const float *root,
                                                   const float *locals,
                                                   float *models,
                                                   size_t count);

/**
 * Does what dq8_rotations_translations_to_model_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_rotations_translations_to_model_f32(size_t lanes,
                                                          const int32_t *parents,
                                                          size_t joints,
                                                          const float *root,
                                                          const float *locals,
                                                          float *models,
                                                          size_t count);

/**
 * Computes model poses and the skinning palette in one pass. The model poses are those
 * of dq8_local_to_model. The palette is `palette[j] = models[j] * inverse_binds[j]`,
 * which moves the mesh at rest with joint j.
 *
 * `inverse_binds` holds `joints` plain motions, which are the same for all instances.
 * `models` and `palette` hold `count` motions, like `locals`, and must not overlap any
 * other array.
 */
dq8_status dq8_palette_f32(const int32_t *parents,
                           size_t joints,
                           const float *root,
                           const float *locals,
                           const float *inverse_binds,
                           float *models,
                           float *palette,
                           size_t count);

/**
 * Does what dq8_palette_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_palette_f32(size_t lanes,
                                  const int32_t *parents,
                                  size_t joints,
                                  const float *root,
                                  const float *locals,
                                  const float *inverse_binds,
                                  float *models,
                                  float *palette,
                                  size_t count);

/**
 * Computes model poses and the palette like dq8_palette, but with matrices in the
 * palette. Each entry is a matrix `[R | t]` of twelve components, row by row.
 */
dq8_status dq8_palette_matrices_f32(const int32_t *parents,
                                    size_t joints,
                                    const float *root,
                                    const float *locals,
                                    const float *inverse_binds,
                                    float *models,
                                    float *palette,
                                    size_t count);

/**
 * Does what dq8_palette_matrices_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_palette_matrices_f32(size_t lanes,
                                           const int32_t *parents,
                                           size_t joints,
                                           const float *root,
                                           const float *locals,
                                           const float *inverse_binds,
                                           float *models,
                                           float *palette,
                                           size_t count);

/**
 * Computes model poses from local poses: `models[j] = models[parents[j]] * locals[j]`.
 *
 * `parents` holds `joints` indices of parents, or -1 for a joint without a parent.
 * `root` is a motion that moves all joints without a parent, or null. `locals` and
 * `models` are `[instance][joint]` and hold `count` motions: `joints` times the number
 * of instances. In blocks they are `[block of instances][joint]`, and `count` is
 * `joints` times the number of blocks of instances: the number of instances over
 * `lanes`, rounded up. `models` may be `locals`. Returns DQ8_STATUS_LENGTH if `count`
 * is no multiple of `joints`.
 */
dq8_status dq8_local_to_model_f64(const int32_t *parents,
                                  size_t joints,
                                  const double *root,
                                  const double *locals,
                                  double *models,
                                  size_t count);

/**
 * Does what dq8_local_to_model_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_local_to_model_f64(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const double *root,
                                         const double *locals,
                                         double *models,
                                         size_t count);

/**
 * Computes local poses from unit model poses. This is the inverse of
 * dq8_local_to_model, and the arrays have the same shapes. `locals` may be `models`.
 */
dq8_status dq8_model_to_local_f64(const int32_t *parents,
                                  size_t joints,
                                  const double *root,
                                  const double *models,
                                  double *locals,
                                  size_t count);

/**
 * Does what dq8_model_to_local_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_model_to_local_f64(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const double *root,
                                         const double *models,
                                         double *locals,
                                         size_t count);

/**
 * Computes model poses from rotations and fixed offsets. Animation clips often hold
 * local poses in this form. `rotations` holds `count` unit quaternions (x, y, z, w).
 * `offsets` holds `joints` translations (x, y, z): the position of each joint in its
 * parent, which is the same in all instances. Other arguments and errors are those of
 * dq8_local_to_model.
 */
dq8_status dq8_rotations_to_model_f64(const int32_t *parents,
                                      size_t joints,
                                      const double *root,
                                      const double *rotations,
                                      const double *offsets,
                                      double *models,
                                      size_t count);

/**
 * Does what dq8_rotations_to_model_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_rotations_to_model_f64(size_t lanes,
                                             const int32_t *parents,
                                             size_t joints,
                                             const double *root,
                                             const double *rotations,
                                             const double *offsets,
                                             double *models,
                                             size_t count);

/**
 * Computes model poses from rotations and translations. `locals` holds `count` local
 * poses of seven components: a unit quaternion (x, y, z, w), then a translation (x, y,
 * z). Other arguments and errors are those of dq8_local_to_model.
 */
dq8_status dq8_rotations_translations_to_model_f64(const int32_t *parents,
                                                   size_t joints,
                                                   const double *root,
                                                   const double *locals,
                                                   double *models,
                                                   size_t count);

/**
 * Does what dq8_rotations_translations_to_model_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_rotations_translations_to_model_f64(size_t lanes,
                                                          const int32_t *parents,
                                                          size_t joints,
                                                          const double *root,
                                                          const double *locals,
                                                          double *models,
                                                          size_t count);

/**
 * Computes model poses and the skinning palette in one pass. The model poses are those
 * of dq8_local_to_model. The palette is `palette[j] = models[j] * inverse_binds[j]`,
 * which moves the mesh at rest with joint j.
 *
 * `inverse_binds` holds `joints` plain motions, which are the same for all instances.
 * `models` and `palette` hold `count` motions, like `locals`, and must not overlap any
 * other array.
 */
dq8_status dq8_palette_f64(const int32_t *parents,
                           size_t joints,
                           const double *root,
                           const double *locals,
                           const double *inverse_binds,
                           double *models,
                           double *palette,
                           size_t count);

/**
 * Does what dq8_palette_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_palette_f64(size_t lanes,
                                  const int32_t *parents,
                                  size_t joints,
                                  const double *root,
                                  const double *locals,
                                  const double *inverse_binds,
                                  double *models,
                                  double *palette,
                                  size_t count);

/**
 * Computes model poses and the palette like dq8_palette, but with matrices in the
 * palette. Each entry is a matrix `[R | t]` of twelve components, row by row.
 */
dq8_status dq8_palette_matrices_f64(const int32_t *parents,
                                    size_t joints,
                                    const double *root,
                                    const double *locals,
                                    const double *inverse_binds,
                                    double *models,
                                    double *palette,
                                    size_t count);

/**
 * Does what dq8_palette_matrices_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_palette_matrices_f64(size_t lanes,
                                           const int32_t *parents,
                                           size_t joints,
                                           const double *root,
                                           const double *locals,
                                           const double *inverse_binds,
                                           double *models,
                                           double *palette,
                                           size_t count);

/**
 * Computes the poses of all links for many configurations: forward kinematics.
 * `values` is `[configuration][value]` and holds `value_count` values: the
 * mechanism's number of values times the number of configurations. `poses` is
 * `[configuration][link]` and holds `count` motions: the mechanism's number of
 * links times the number of configurations.
 *
 * In blocks, `poses` is `[block of configurations][link]`, and `count` is the number
 * of links times the number of blocks of configurations: the number of configurations
 * over `lanes`, rounded up. `values` is a plain array in either case. Lanes without a
 * configuration get the poses for values that are all zero. Returns
 * DQ8_STATUS_LENGTH_VALUES if `value_count` and `count` belong to different numbers of
 * configurations.
 */
dq8_status dq8_link_poses_f32(const struct dq8_mechanism_f32 *mechanism,
                              const float *values,
                              size_t value_count,
                              float *poses,
                              size_t count);

/**
 * Does what dq8_link_poses_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_link_poses_f32(size_t lanes,
                                     const struct dq8_mechanism_f32 *mechanism,
                                     const float *values,
                                     size_t value_count,
                                     float *poses,
                                     size_t count);

/**
 * Computes the Jacobians and the poses of some links for many configurations.
 * `links` holds the indices of `link_count` links. `values` is
 * `[configuration][value]` and holds `value_count` values in all. `poses` is
 * `[configuration][link]`, in the order of `links`, and holds `count` motions in all:
 * `link_count` times the number of configurations. `columns` is
 * `[configuration][link][rate]` and holds `count` times the mechanism's number of
 * rates columns, of six components each, in `frame`, one of enum dq8_frame: see
 * dq8_mechanism_link_jacobian.
 *
 * In blocks, `poses` and `columns` are `[block of configurations]` and so on, and
 * `count` is `link_count` times the number of blocks of configurations. `values` is a
 * plain array in either case. Returns DQ8_STATUS_NO_LINK, DQ8_STATUS_UNKNOWN_VALUE (of
 * `frame`), DQ8_STATUS_LENGTH if `count` is no multiple of `link_count`, and
 * DQ8_STATUS_LENGTH_VALUES if `value_count` belongs to another number of
 * configurations than `count`.
 */
dq8_status dq8_link_jacobians_f32(const struct dq8_mechanism_f32 *mechanism,
                                  int32_t frame,
                                  const float *values,
                                  size_t value_count,
                                  const size_t *links,
                                  size_t link_count,
                                  float *poses,
                                  float *columns,
                                  size_t count);

/**
 * Does what dq8_link_jacobians_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_link_jacobians_f32(size_t lanes,
                                         const struct dq8_mechanism_f32 *mechanism,
                                         int32_t frame,
                                         const float *values,
                                         size_t value_count,
                                         const size_t *links,
                                         size_t link_count,
                                         float *poses,
                                         float *columns,
                                         size_t count);

/**
 * Computes the poses of all links for many configurations: forward kinematics.
 * `values` is `[configuration][value]` and holds `value_count` values: the
 * mechanism's number of values times the number of configurations. `poses` is
 * `[configuration][link]` and holds `count` motions: the mechanism's number of
 * links times the number of configurations.
 *
 * In blocks, `poses` is `[block of configurations][link]`, and `count` is the number
 * of links times the number of blocks of configurations: the number of configurations
 * over `lanes`, rounded up. `values` is a plain array in either case. Lanes without a
 * configuration get the poses for values that are all zero. Returns
 * DQ8_STATUS_LENGTH_VALUES if `value_count` and `count` belong to different numbers of
 * configurations.
 */
dq8_status dq8_link_poses_f64(const struct dq8_mechanism_f64 *mechanism,
                              const double *values,
                              size_t value_count,
                              double *poses,
                              size_t count);

/**
 * Does what dq8_link_poses_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_link_poses_f64(size_t lanes,
                                     const struct dq8_mechanism_f64 *mechanism,
                                     const double *values,
                                     size_t value_count,
                                     double *poses,
                                     size_t count);

/**
 * Computes the Jacobians and the poses of some links for many configurations.
 * `links` holds the indices of `link_count` links. `values` is
 * `[configuration][value]` and holds `value_count` values in all. `poses` is
 * `[configuration][link]`, in the order of `links`, and holds `count` motions in all:
 * `link_count` times the number of configurations. `columns` is
 * `[configuration][link][rate]` and holds `count` times the mechanism's number of
 * rates columns, of six components each, in `frame`, one of enum dq8_frame: see
 * dq8_mechanism_link_jacobian.
 *
 * In blocks, `poses` and `columns` are `[block of configurations]` and so on, and
 * `count` is `link_count` times the number of blocks of configurations. `values` is a
 * plain array in either case. Returns DQ8_STATUS_NO_LINK, DQ8_STATUS_UNKNOWN_VALUE (of
 * `frame`), DQ8_STATUS_LENGTH if `count` is no multiple of `link_count`, and
 * DQ8_STATUS_LENGTH_VALUES if `value_count` belongs to another number of
 * configurations than `count`.
 */
dq8_status dq8_link_jacobians_f64(const struct dq8_mechanism_f64 *mechanism,
                                  int32_t frame,
                                  const double *values,
                                  size_t value_count,
                                  const size_t *links,
                                  size_t link_count,
                                  double *poses,
                                  double *columns,
                                  size_t count);

/**
 * Does what dq8_link_jacobians_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_link_jacobians_f64(size_t lanes,
                                         const struct dq8_mechanism_f64 *mechanism,
                                         int32_t frame,
                                         const double *values,
                                         size_t value_count,
                                         const size_t *links,
                                         size_t link_count,
                                         double *poses,
                                         double *columns,
                                         size_t count);

/**
 * Computes the intrinsic mean of `count` unit motions: the logarithms of the motions,
 * as seen from the mean, sum to zero when they are multiplied by `weights`. `weights`
 * may be null for equal weights.
 *
 * The search begins at dq8_motion_blend and takes at most `max_iterations` steps, for
 * which 32 are enough. The search has converged when a step turns by at most
 * `tolerance` radians and moves by at most `tolerance` times the longest dual part. A
 * good tolerance is 1e-6 for float, and 1e-14 for double. `converged`, which may be
 * null, is set to 1 if the search has converged, and to 0 if it has not.
 *
 * If all motions are multiplied by the same motion, so is their mean. There may be
 * several means if motions are more than a quarter of a turn away from a mean. Returns
 * DQ8_STATUS_NO_INFLUENCES if `count` is 0, and DQ8_STATUS_NOT_NORMALIZABLE if there
 * is no mean.
 */
dq8_status dq8_motion_mean_f32(const float *motions,
                               const float *weights,
                               size_t count,
                               float tolerance,
                               uint32_t max_iterations,
                               float *out,
                               int32_t *converged);

/**
 * Computes the intrinsic mean of `count` unit motions: the logarithms of the motions,
 * as seen from the mean, sum to zero when they are multiplied by `weights`. `weights`
 * may be null for equal weights.
 *
 * The search begins at dq8_motion_blend and takes at most `max_iterations` steps, for
 * which 32 are enough. The search has converged when a step turns by at most
 * `tolerance` radians and moves by at most `tolerance` times the longest dual part. A
 * good tolerance is 1e-6 for float, and 1e-14 for double. `converged`, which may be
 * null, is set to 1 if the search has converged, and to 0 if it has not.
 *
 * If all motions are multiplied by the same motion, so is their mean. There may be
 * several means if motions are more than a quarter of a turn away from a mean. Returns
 * DQ8_STATUS_NO_INFLUENCES if `count` is 0, and DQ8_STATUS_NOT_NORMALIZABLE if there
 * is no mean.
 */
dq8_status dq8_motion_mean_f64(const double *motions,
                               const double *weights,
                               size_t count,
                               double tolerance,
                               uint32_t max_iterations,
                               double *out,
                               int32_t *converged);

/**
 * Makes a mechanism of `count` joints. It checks the joints once, so that the
 * functions of the mechanism need not. `steps` is memory for `count` steps, to which
 * the mechanism points. The behaviour of its functions is undefined if the program
 * changes or frees the steps. The `joints` are not needed afterwards.
 *
 * Returns DQ8_STATUS_PARENT_NOT_BEFORE, _PARENT_OUT_OF_RANGE, _NOT_UNIT (of a
 * placement), _NOT_FINITE, _AXIS, _MIMIC, _LIMITS or _UNKNOWN_VALUE (of a kind,
 * `mimics` or `limited`) if a joint is wrong, and sets `bad_joint`, which may be null,
 * to its index. The function may then have written `steps`, but not the mechanism.
 */
dq8_status dq8_mechanism_make_f32(const struct dq8_joint_f32 *joints,
                                  size_t count,
                                  struct dq8_step_f32 *steps,
                                  struct dq8_mechanism_f32 *mechanism,
                                  size_t *bad_joint);

/**
 * Computes the poses of all links in the frame of the base: forward kinematics of one
 * configuration, `poses[j] = poses[parent] * placement[j] * motion of joint j`.
 * Returns DQ8_STATUS_LENGTH_VALUES if `value_count` is not the mechanism's number of
 * values, and DQ8_STATUS_LENGTH if `link_count` is not its number of links.
 */
dq8_status dq8_mechanism_link_poses_f32(const struct dq8_mechanism_f32 *mechanism,
                                        const float *values,
                                        size_t value_count,
                                        float *poses,
                                        size_t link_count);

/**
 * Computes the pose of one link in the frame of the base. It computes only the joints
 * that carry the link. `link` is the index of the link. Returns DQ8_STATUS_NO_LINK if
 * there is no such link.
 */
dq8_status dq8_mechanism_link_pose_f32(const struct dq8_mechanism_f32 *mechanism,
                                       const float *values,
                                       size_t value_count,
                                       size_t link,
                                       float *pose);

/**
 * Computes the geometric Jacobian of a link. It has a column for each rate of the
 * mechanism. A column has six components: angular velocity x y z, then linear velocity
 * x y z, in `frame`, one of enum dq8_frame. Columns of joints that do not carry the
 * link are zero.
 *
 * `column_count` must be the mechanism's number of rates. The pose of the link is
 * written to `pose`, which may be null. Returns DQ8_STATUS_NO_LINK if there is no such
 * link, and DQ8_STATUS_UNKNOWN_VALUE if `frame` is no value of the enum.
 */
dq8_status dq8_mechanism_link_jacobian_f32(const struct dq8_mechanism_f32 *mechanism,
                                           int32_t frame,
                                           const float *values,
                                           size_t value_count,
                                           size_t link,
                                           float *columns,
                                           size_t column_count,
                                           float *pose);

/**
 * Computes the manipulability of a link: the root of the determinant of its Jacobian
 * times the transposed Jacobian (Yoshikawa 1985). It is 0 where the link cannot move
 * in some direction, and for fewer than six rates; it does not depend on the frame.
 * `columns` is scratch for `column_count` columns of six components, and
 * `column_count` must be the mechanism's number of rates. Returns DQ8_STATUS_NO_LINK
 * if there is no such link.
 */
dq8_status dq8_mechanism_manipulability_f32(const struct dq8_mechanism_f32 *mechanism,
                                            const float *values,
                                            size_t value_count,
                                            size_t link,
                                            float *columns,
                                            size_t column_count,
                                            float *manipulability);

/**
 * Computes the rates that move a link best with the velocity `twist`: six components,
 * angular x y z, then linear x y z, in `frame`, one of enum dq8_frame. The sum of the
 * squared errors, plus the square of `damping` times the squared rates, is least.
 * Without damping, which is 0, rates that move nothing are 0, and rates near a
 * singular configuration are large.
 *
 * `column_count` must be the mechanism's number of rates, which is the length of
 * `rates`. `columns` is scratch for as many columns of six components. Returns
 * DQ8_STATUS_NO_LINK if there is no such link, and DQ8_STATUS_UNKNOWN_VALUE if `frame`
 * is no value of the enum, or `damping` is negative or not finite.
 */
dq8_status dq8_mechanism_rates_for_f32(const struct dq8_mechanism_f32 *mechanism,
                                       int32_t frame,
                                       const float *values,
                                       size_t value_count,
                                       size_t link,
                                       const float *twist,
                                       float damping,
                                       float *columns,
                                       float *rates,
                                       size_t column_count);

/**
 * Makes a mechanism of `count` joints. It checks the joints once, so that the
 * functions of the mechanism need not. `steps` is memory for `count` steps, to which
 * the mechanism points. The behaviour of its functions is undefined if the program
 * changes or frees the steps. The `joints` are not needed afterwards.
 *
 * Returns DQ8_STATUS_PARENT_NOT_BEFORE, _PARENT_OUT_OF_RANGE, _NOT_UNIT (of a
 * placement), _NOT_FINITE, _AXIS, _MIMIC, _LIMITS or _UNKNOWN_VALUE (of a kind,
 * `mimics` or `limited`) if a joint is wrong, and sets `bad_joint`, which may be null,
 * to its index. The function may then have written `steps`, but not the mechanism.
 */
dq8_status dq8_mechanism_make_f64(const struct dq8_joint_f64 *joints,
                                  size_t count,
                                  struct dq8_step_f64 *steps,
                                  struct dq8_mechanism_f64 *mechanism,
                                  size_t *bad_joint);

/**
 * Computes the poses of all links in the frame of the base: forward kinematics of one
 * configuration, `poses[j] = poses[parent] * placement[j] * motion of joint j`.
 * Returns DQ8_STATUS_LENGTH_VALUES if `value_count` is not the mechanism's number of
 * values, and DQ8_STATUS_LENGTH if `link_count` is not its number of links.
 */
dq8_status dq8_mechanism_link_poses_f64(const struct dq8_mechanism_f64 *mechanism,
                                        const double *values,
                                        size_t value_count,
                                        double *poses,
                                        size_t link_count);

/**
 * Computes the pose of one link in the frame of the base. It computes only the joints
 * that carry the link. `link` is the index of the link. Returns DQ8_STATUS_NO_LINK if
 * there is no such link.
 */
dq8_status dq8_mechanism_link_pose_f64(const struct dq8_mechanism_f64 *mechanism,
                                       const double *values,
                                       size_t value_count,
                                       size_t link,
                                       double *pose);

/**
 * Computes the geometric Jacobian of a link. It has a column for each rate of the
 * mechanism. A column has six components: angular velocity x y z, then linear velocity
 * x y z, in `frame`, one of enum dq8_frame. Columns of joints that do not carry the
 * link are zero.
 *
 * `column_count` must be the mechanism's number of rates. The pose of the link is
 * written to `pose`, which may be null. Returns DQ8_STATUS_NO_LINK if there is no such
 * link, and DQ8_STATUS_UNKNOWN_VALUE if `frame` is no value of the enum.
 */
dq8_status dq8_mechanism_link_jacobian_f64(const struct dq8_mechanism_f64 *mechanism,
                                           int32_t frame,
                                           const double *values,
                                           size_t value_count,
                                           size_t link,
                                           double *columns,
                                           size_t column_count,
                                           double *pose);

/**
 * Computes the manipulability of a link: the root of the determinant of its Jacobian
 * times the transposed Jacobian (Yoshikawa 1985). It is 0 where the link cannot move
 * in some direction, and for fewer than six rates; it does not depend on the frame.
 * `columns` is scratch for `column_count` columns of six components, and
 * `column_count` must be the mechanism's number of rates. Returns DQ8_STATUS_NO_LINK
 * if there is no such link.
 */
dq8_status dq8_mechanism_manipulability_f64(const struct dq8_mechanism_f64 *mechanism,
                                            const double *values,
                                            size_t value_count,
                                            size_t link,
                                            double *columns,
                                            size_t column_count,
                                            double *manipulability);

/**
 * Computes the rates that move a link best with the velocity `twist`: six components,
 * angular x y z, then linear x y z, in `frame`, one of enum dq8_frame. The sum of the
 * squared errors, plus the square of `damping` times the squared rates, is least.
 * Without damping, which is 0, rates that move nothing are 0, and rates near a
 * singular configuration are large.
 *
 * `column_count` must be the mechanism's number of rates, which is the length of
 * `rates`. `columns` is scratch for as many columns of six components. Returns
 * DQ8_STATUS_NO_LINK if there is no such link, and DQ8_STATUS_UNKNOWN_VALUE if `frame`
 * is no value of the enum, or `damping` is negative or not finite.
 */
dq8_status dq8_mechanism_rates_for_f64(const struct dq8_mechanism_f64 *mechanism,
                                       int32_t frame,
                                       const double *values,
                                       size_t value_count,
                                       size_t link,
                                       const double *twist,
                                       double damping,
                                       double *columns,
                                       double *rates,
                                       size_t column_count);

/**
 * Writes the identity: the motion that moves nothing.
 */
dq8_status dq8_motion_identity_f32(float *out);

/**
 * Makes the motion that rotates by the unit quaternion `rotation` (x, y, z, w), and
 * then moves by `translation` (x, y, z).
 */
dq8_status dq8_motion_from_rotation_translation_f32(const float *rotation,
                                                    const float *translation,
                                                    float *out);

/**
 * Writes the parts of a unit motion: the quaternion `rotation` (x, y, z, w) and
 * `translation` (x, y, z), which must not overlap each other.
 */
dq8_status dq8_motion_to_rotation_translation_f32(const float *motion,
                                                  float *rotation,
                                                  float *translation);

/**
 * Makes the motion of a matrix of three rows and four columns. `matrix` has twelve
 * components, row by row. The rows of its rotation must be orthonormal: their dot
 * products may differ from 0 and 1 by at most `tolerance`.
 *
 * Returns DQ8_STATUS_NOT_ORTHONORMAL, _MIRRORS or _NOT_FINITE if the matrix is no
 * rigid motion.
 */
dq8_status dq8_motion_from_matrix_3x4_f32(const float *matrix, float tolerance, float *out);

/**
 * Makes the motion of a matrix of four rows and four columns. `matrix` has sixteen
 * components, row by row. Returns DQ8_STATUS_NOT_AFFINE if the last row is not 0 0
 * 0 1. Other arguments and errors are those of dq8_motion_from_matrix_3x4.
 */
dq8_status dq8_motion_from_matrix_4x4_f32(const float *matrix, float tolerance, float *out);

/**
 * Writes the matrix `[R | t]` of a unit motion: twelve components, row by row.
 */
dq8_status dq8_motion_to_matrix_3x4_f32(const float *motion, float *matrix);

/**
 * Writes the 4x4 matrix of a unit motion, with the last row 0 0 0 1: sixteen
 * components, row by row.
 */
dq8_status dq8_motion_to_matrix_4x4_f32(const float *motion, float *matrix);

/**
 * Computes the product `a * b`, in which b acts first.
 */
dq8_status dq8_motion_mul_f32(const float *a, const float *b, float *out);

/**
 * Computes the inverse of a unit motion, which only flips signs.
 */
dq8_status dq8_motion_conjugate_f32(const float *motion, float *out);

/**
 * Computes the inverse of a motion that need not be unit. Returns
 * DQ8_STATUS_NO_INVERSE if the motion has no inverse.
 */
dq8_status dq8_motion_inverse_f32(const float *motion, float *out);

/**
 * Normalizes a dual quaternion to a unit motion. Returns DQ8_STATUS_NOT_NORMALIZABLE
 * if its real part is zero or a component is not finite.
 */
dq8_status dq8_motion_normalize_f32(const float *motion, float *out);

/**
 * Checks that a motion is unit. Returns DQ8_STATUS_NOT_UNIT if its norm differs from 1
 * by more than `tolerance`.
 */
dq8_status dq8_motion_check_unit_f32(const float *motion, float tolerance);

/**
 * Moves a point (x, y, z) by a unit motion.
 */
dq8_status dq8_motion_point_f32(const float *motion, const float *point, float *out);

/**
 * Turns a direction (x, y, z) by a unit motion, which does not translate it.
 */
dq8_status dq8_motion_vector_f32(const float *motion, const float *vector, float *out);

/**
 * Writes the identity: the motion that moves nothing.
 */
dq8_status dq8_motion_identity_f64(double *out);

/**
 * Makes the motion that rotates by the unit quaternion `rotation` (x, y, z, w), and
 * then moves by `translation` (x, y, z).
 */
dq8_status dq8_motion_from_rotation_translation_f64(const double *rotation,
                                                    const double *translation,
                                                    double *out);

/**
 * Writes the parts of a unit motion: the quaternion `rotation` (x, y, z, w) and
 * `translation` (x, y, z), which must not overlap each other.
 */
dq8_status dq8_motion_to_rotation_translation_f64(const double *motion,
                                                  double *rotation,
                                                  double *translation);

/**
 * Makes the motion of a matrix of three rows and four columns. `matrix` has twelve
 * components, row by row. The rows of its rotation must be orthonormal: their dot
 * products may differ from 0 and 1 by at most `tolerance`.
 *
 * Returns DQ8_STATUS_NOT_ORTHONORMAL, _MIRRORS or _NOT_FINITE if the matrix is no
 * rigid motion.
 */
dq8_status dq8_motion_from_matrix_3x4_f64(const double *matrix, double tolerance, double *out);

/**
 * Makes the motion of a matrix of four rows and four columns. `matrix` has sixteen
 * components, row by row. Returns DQ8_STATUS_NOT_AFFINE if the last row is not 0 0
 * 0 1. Other arguments and errors are those of dq8_motion_from_matrix_3x4.
 */
dq8_status dq8_motion_from_matrix_4x4_f64(const double *matrix, double tolerance, double *out);

/**
 * Writes the matrix `[R | t]` of a unit motion: twelve components, row by row.
 */
dq8_status dq8_motion_to_matrix_3x4_f64(const double *motion, double *matrix);

/**
 * Writes the 4x4 matrix of a unit motion, with the last row 0 0 0 1: sixteen
 * components, row by row.
 */
dq8_status dq8_motion_to_matrix_4x4_f64(const double *motion, double *matrix);

/**
 * Computes the product `a * b`, in which b acts first.
 */
dq8_status dq8_motion_mul_f64(const double *a, const double *b, double *out);

/**
 * Computes the inverse of a unit motion, which only flips signs.
 */
dq8_status dq8_motion_conjugate_f64(const double *motion, double *out);

/**
 * Computes the inverse of a motion that need not be unit. Returns
 * DQ8_STATUS_NO_INVERSE if the motion has no inverse.
 */
dq8_status dq8_motion_inverse_f64(const double *motion, double *out);

/**
 * Normalizes a dual quaternion to a unit motion. Returns DQ8_STATUS_NOT_NORMALIZABLE
 * if its real part is zero or a component is not finite.
 */
dq8_status dq8_motion_normalize_f64(const double *motion, double *out);

/**
 * Checks that a motion is unit. Returns DQ8_STATUS_NOT_UNIT if its norm differs from 1
 * by more than `tolerance`.
 */
dq8_status dq8_motion_check_unit_f64(const double *motion, double tolerance);

/**
 * Moves a point (x, y, z) by a unit motion.
 */
dq8_status dq8_motion_point_f64(const double *motion, const double *point, double *out);

/**
 * Turns a direction (x, y, z) by a unit motion, which does not translate it.
 */
dq8_status dq8_motion_vector_f64(const double *motion, const double *vector, double *out);

/**
 * Packs plain poses into blocks. `poses` is `[instance][joint]`, and `blocks` is
 * `[block of instances][joint]`, with `lanes` instances in a block. Lanes without an
 * instance get the identity. Returns DQ8_STATUS_LENGTH_BLOCKS if `block_count` is not
 * `joints` times the number of blocks of instances: the number of instances over
 * `lanes`, rounded up.
 */
dq8_status dq8_pack_f32(size_t lanes,
                        size_t joints,
                        const float *poses,
                        size_t pose_count,
                        float *blocks,
                        size_t block_count);

/**
 * Unpacks blocks into plain poses. This is the inverse of dq8_pack, and the arrays
 * have the same shapes. Lanes after the last instance are ignored.
 */
dq8_status dq8_unpack_f32(size_t lanes,
                          size_t joints,
                          const float *blocks,
                          size_t block_count,
                          float *poses,
                          size_t pose_count);

/**
 * Packs the links of a chain into blocks. Each lane holds a segment of `block_count`
 * links: link i goes to lane `i / block_count` of block `i % block_count`. Places
 * after the last link get the identity. Returns DQ8_STATUS_LENGTH if `block_count` is
 * not `link_count` over `lanes`, rounded up.
 */
dq8_status dq8_pack_chain_f32(size_t lanes,
                              const float *links,
                              size_t link_count,
                              float *blocks,
                              size_t block_count);

/**
 * Unpacks the blocks of a chain into plain links. This is the inverse of
 * dq8_pack_chain.
 */
dq8_status dq8_unpack_chain_f32(size_t lanes,
                                const float *blocks,
                                size_t block_count,
                                float *links,
                                size_t link_count);

/**
 * Returns the size of a block, counted in floats or doubles. It is `lanes` times
 * `components`, rounded up to whole 64 bytes. A motion has 8 components, a point 3, a
 * rotation 4, a rotation with a translation 7, and a matrix 12 or 16.
 */
size_t dq8_block_size_f32(size_t lanes, size_t components);

/**
 * Packs plain poses into blocks. `poses` is `[instance][joint]`, and `blocks` is
 * `[block of instances][joint]`, with `lanes` instances in a block. Lanes without an
 * instance get the identity. Returns DQ8_STATUS_LENGTH_BLOCKS if `block_count` is not
 * `joints` times the number of blocks of instances: the number of instances over
 * `lanes`, rounded up.
 */
dq8_status dq8_pack_f64(size_t lanes,
                        size_t joints,
                        const double *poses,
                        size_t pose_count,
                        double *blocks,
                        size_t block_count);

/**
 * Unpacks blocks into plain poses. This is the inverse of dq8_pack, and the arrays
 * have the same shapes. Lanes after the last instance are ignored.
 */
dq8_status dq8_unpack_f64(size_t lanes,
                          size_t joints,
                          const double *blocks,
                          size_t block_count,
                          double *poses,
                          size_t pose_count);

/**
 * Packs the links of a chain into blocks. Each lane holds a segment of `block_count`
 * links: link i goes to lane `i / block_count` of block `i % block_count`. Places
 * after the last link get the identity. Returns DQ8_STATUS_LENGTH if `block_count` is
 * not `link_count` over `lanes`, rounded up.
 */
dq8_status dq8_pack_chain_f64(size_t lanes,
                              const double *links,
                              size_t link_count,
                              double *blocks,
                              size_t block_count);

/**
 * Unpacks the blocks of a chain into plain links. This is the inverse of
 * dq8_pack_chain.
 */
dq8_status dq8_unpack_chain_f64(size_t lanes,
                                const double *blocks,
                                size_t block_count,
                                double *links,
                                size_t link_count);

/**
 * Returns the size of a block, counted in floats or doubles. It is `lanes` times
 * `components`, rounded up to whole 64 bytes. A motion has 8 components, a point 3, a
 * rotation 4, a rotation with a translation 7, and a matrix 12 or 16.
 */
size_t dq8_block_size_f64(size_t lanes, size_t components);

/**
 * Computes a palette of matrices, `matrices[j] = models[j] * inverse_binds[j]`.
 * `models` and `inverse_binds` are 4x4 matrices whose components are in `order`, one
 * of enum dq8_matrix_order. `matrices` has twelve components per joint, row by row, in
 * either order. Returns DQ8_STATUS_NOT_FINITE if an input is not finite, and
 * DQ8_STATUS_NOT_AFFINE if the last row of an input is not 0 0 0 1.
 */
dq8_status dq8_skin_products_f32(const float *models,
                                 const float *inverse_binds,
                                 int32_t order,
                                 float *matrices,
                                 size_t joint_count);

/**
 * Splits the matrices of a palette into stretches and unit motions. Both are palettes
 * for dq8_skin_stretched. A matrix is the product of the motion and the stretch, and
 * the stretch acts first. `matrices` and `stretches` have twelve components per joint,
 * row by row. Returns DQ8_STATUS_NOT_FINITE if a component is not finite.
 */
dq8_status dq8_skin_split_f32(const float *matrices,
                              float *motions,
                              float *stretches,
                              size_t joint_count);

/**
 * Computes a palette of matrices, `matrices[j] = models[j] * inverse_binds[j]`.
 * `models` and `inverse_binds` are 4x4 matrices whose components are in `order`, one
 * of enum dq8_matrix_order. `matrices` has twelve components per joint, row by row, in
 * either order. Returns DQ8_STATUS_NOT_FINITE if an input is not finite, and
 * DQ8_STATUS_NOT_AFFINE if the last row of an input is not 0 0 0 1.
 */
dq8_status dq8_skin_products_f64(const double *models,
                                 const double *inverse_binds,
                                 int32_t order,
                                 double *matrices,
                                 size_t joint_count);

/**
 * Splits the matrices of a palette into stretches and unit motions. Both are palettes
 * for dq8_skin_stretched. A matrix is the product of the motion and the stretch, and
 * the stretch acts first. `matrices` and `stretches` have twelve components per joint,
 * row by row. Returns DQ8_STATUS_NOT_FINITE if a component is not finite.
 */
dq8_status dq8_skin_split_f64(const double *matrices,
                              double *motions,
                              double *stretches,
                              size_t joint_count);

/**
 * Finds the fastest order of joints for dq8_plan_local_to_model. Joints at the head of long chains
 * come early, and between a joint and its parent the order has other joints, so that the CPU need
 * not wait for the parent.
 *
 * `order` holds two elements per joint, and must not change while it is used. `scratch` holds six
 * elements per joint, whose content is not needed afterwards. If `parents` is wrong, the function
 * returns the status of dq8_check_parents and sets `bad_joint`, which may be null, to the index of
 * the wrong joint.
 */
dq8_status dq8_plan_make(const int32_t *parents,
                         size_t joints,
                         uint32_t *order,
                         uint32_t *scratch,
                         size_t *bad_joint);

/**
 * Computes model poses like dq8_local_to_model, in a faster order. `order` is the
 * order that dq8_plan_make has found for the same parents. This is the fastest
 * function for one instance. Several instances are computed in the order of
 * dq8_local_to_model. `count` is `joints` times the number of instances. `models` may
 * be `locals`.
 *
 * Returns DQ8_STATUS_NO_PLAN if a pair of `order` is not a joint and its parent, or if
 * a root comes after other joints. The function does not notice whether pairs have
 * changed places.
 */
dq8_status dq8_plan_local_to_model_f32(const int32_t *parents,
                                       const uint32_t *order,
                                       size_t joints,
                                       const float *locals,
                                       float *models,
                                       size_t count);

/**
 * Computes model poses like dq8_local_to_model, in a faster order. `order` is the
 * order that dq8_plan_make has found for the same parents. This is the fastest
 * function for one instance. Several instances are computed in the order of
 * dq8_local_to_model. `count` is `joints` times the number of instances. `models` may
 * be `locals`.
 *
 * Returns DQ8_STATUS_NO_PLAN if a pair of `order` is not a joint and its parent, or if
 * a root comes after other joints. The function does not notice whether pairs have
 * changed places.
 */
dq8_status dq8_plan_local_to_model_f64(const int32_t *parents,
                                       const uint32_t *order,
                                       size_t joints,
                                       const double *locals,
                                       double *models,
                                       size_t count);

/**
 * Writes the default options: tolerances of 1e-5 radians and 1e-5 units of length, 100
 * iterations, with restarts.
 */
dq8_status dq8_mechanism_reach_options_f32(struct dq8_reach_options_f32 *options);

/**
 * Writes the size that `scratch` of dq8_mechanism_reach must have. The size counts
 * floats or doubles. It depends on the mechanism and the number of goals only. Returns
 * DQ8_STATUS_TOO_LARGE if there are more than 1024 goals.
 */
dq8_status dq8_mechanism_reach_scratch_f32(const struct dq8_mechanism_f32 *mechanism,
                                           size_t goal_count,
                                           size_t *scratch_count);

/**
 * Solves the inverse kinematics of one configuration. The search begins at `values`
 * and changes them, within the limits of the joints, until the link of each goal is at
 * its target. `targets` holds a unit motion for each goal. From values near a solution
 * the search converges in a few steps.
 *
 * `posture` is a configuration that the search prefers where the goals leave freedom.
 * It holds as many elements as `values`, or is null. `options` may be null for the
 * options that dq8_mechanism_reach_options writes. The content of `scratch` does not
 * matter. DQ8_STATUS_OK means that `report` has been written, whose `outcome` tells
 * whether the targets are reached.
 *
 * Returns DQ8_STATUS_NO_LINK, _UNMOVED, _WEIGHT (a weight is negative or not finite,
 * or all weights of a goal are 0, or there is no goal), _LIMITS, _NOT_FINITE (of the
 * posture or of a point), _LENGTH_VALUES, _LENGTH_SCRATCH or _UNKNOWN_VALUE (of
 * `restarts`) for wrong inputs. The function may then have written `scratch`, but not
 * the values and the report.
 */
dq8_status dq8_mechanism_reach_f32(const struct dq8_mechanism_f32 *mechanism,
                                   const struct dq8_goal_f32 *goals,
                                   const float *targets,
                                   size_t goal_count,
                                   const float *posture,
                                   const struct dq8_reach_options_f32 *options,
                                   float *values,
                                   size_t value_count,
                                   float *scratch,
                                   size_t scratch_count,
                                   struct dq8_reach_report_f32 *report);

/**
 * Writes the default options: tolerances of 1e-5 radians and 1e-5 units of length, 100
 * iterations, with restarts.
 */
dq8_status dq8_mechanism_reach_options_f64(struct dq8_reach_options_f64 *options);

/**
 * Writes the size that `scratch` of dq8_mechanism_reach must have. The size counts
 * floats or doubles. It depends on the mechanism and the number of goals only. Returns
 * DQ8_STATUS_TOO_LARGE if there are more than 1024 goals.
 */
dq8_status dq8_mechanism_reach_scratch_f64(const struct dq8_mechanism_f64 *mechanism,
                                           size_t goal_count,
                                           size_t *scratch_count);

/**
 * Solves the inverse kinematics of one configuration. The search begins at `values`
 * and changes them, within the limits of the joints, until the link of each goal is at
 * its target. `targets` holds a unit motion for each goal. From values near a solution
 * the search converges in a few steps.
 *
 * `posture` is a configuration that the search prefers where the goals leave freedom.
 * It holds as many elements as `values`, or is null. `options` may be null for the
 * options that dq8_mechanism_reach_options writes. The content of `scratch` does not
 * matter. DQ8_STATUS_OK means that `report` has been written, whose `outcome` tells
 * whether the targets are reached.
 *
 * Returns DQ8_STATUS_NO_LINK, _UNMOVED, _WEIGHT (a weight is negative or not finite,
 * or all weights of a goal are 0, or there is no goal), _LIMITS, _NOT_FINITE (of the
 * posture or of a point), _LENGTH_VALUES, _LENGTH_SCRATCH or _UNKNOWN_VALUE (of
 * `restarts`) for wrong inputs. The function may then have written `scratch`, but not
 * the values and the report.
 */
dq8_status dq8_mechanism_reach_f64(const struct dq8_mechanism_f64 *mechanism,
                                   const struct dq8_goal_f64 *goals,
                                   const double *targets,
                                   size_t goal_count,
                                   const double *posture,
                                   const struct dq8_reach_options_f64 *options,
                                   double *values,
                                   size_t value_count,
                                   double *scratch,
                                   size_t scratch_count,
                                   struct dq8_reach_report_f64 *report);

/**
 * Interpolates from `a` (t = 0) to `b` (t = 1) by the shorter way: the normalized
 * linear interpolation. Returns DQ8_STATUS_NOT_NORMALIZABLE if the weighted sum cannot
 * be normalized to a motion.
 */
dq8_status dq8_motion_nlerp_f32(const float *a, const float *b, float t, float *out);

/**
 * Interpolates along one screw, from unit `a` (t = 0) to unit `b` (t = 1). The motion
 * has constant speed and goes by the shorter way.
 */
dq8_status dq8_motion_sclerp_f32(const float *a, const float *b, float t, float *out);

/**
 * Blends `count` unit motions by `weights`, which need not sum to 1. This is dual
 * quaternion linear blending: each motion gets the sign with which its real part has a
 * dot product of at least 0 with the real part of the first motion, and the weighted
 * sum is normalized.
 *
 * Returns DQ8_STATUS_NO_INFLUENCES if `count` is 0, and DQ8_STATUS_NOT_NORMALIZABLE if
 * the weighted sum cannot be normalized to a motion.
 */
dq8_status dq8_motion_blend_f32(const float *motions,
                                const float *weights,
                                size_t count,
                                float *out);

/**
 * Writes the logarithm of a unit motion. It has six components: the real part x y z,
 * which is half the angle times the axis, then the dual part x y z. What other
 * libraries call the logarithm, twice as large, is the twist that dq8_motion_to_twist
 * writes.
 */
dq8_status dq8_motion_log_f32(const float *motion, float *log);

/**
 * Writes the unit motion whose logarithm is `log`: six components, as dq8_motion_log
 * writes them. Of a twist, dq8_from_twist computes the motion.
 */
dq8_status dq8_motion_exp_f32(const float *log, float *out);

/**
 * Raises a unit motion to the power `t`. The power has the same screw axis, and t
 * times the angle and the slide.
 */
dq8_status dq8_motion_pow_f32(const float *motion, float t, float *out);

/**
 * Writes the screw of a unit motion as eight values. They are the direction x y z of
 * the axis, the moment x y z of the axis, the angle from 0 to pi, and the slide along
 * the axis. A translation has angle 0.
 */
dq8_status dq8_motion_to_screw_f32(const float *motion, float *screw);

/**
 * Writes the motion of a screw, which `numbers` gives as eight values. They are the
 * direction x y z of the axis, of length 1, the moment x y z of the axis, at right
 * angles to the direction, the angle, and the slide along the axis.
 */
dq8_status dq8_motion_from_screw_f32(const float *numbers, float *out);

/**
 * Interpolates from `a` (t = 0) to `b` (t = 1) by the shorter way: the normalized
 * linear interpolation. Returns DQ8_STATUS_NOT_NORMALIZABLE if the weighted sum cannot
 * be normalized to a motion.
 */
dq8_status dq8_motion_nlerp_f64(const double *a, const double *b, double t, double *out);

/**
 * Interpolates along one screw, from unit `a` (t = 0) to unit `b` (t = 1). The motion
 * has constant speed and goes by the shorter way.
 */
dq8_status dq8_motion_sclerp_f64(const double *a, const double *b, double t, double *out);

/**
 * Blends `count` unit motions by `weights`, which need not sum to 1. This is dual
 * quaternion linear blending: each motion gets the sign with which its real part has a
 * dot product of at least 0 with the real part of the first motion, and the weighted
 * sum is normalized.
 *
 * Returns DQ8_STATUS_NO_INFLUENCES if `count` is 0, and DQ8_STATUS_NOT_NORMALIZABLE if
 * the weighted sum cannot be normalized to a motion.
 */
dq8_status dq8_motion_blend_f64(const double *motions,
                                const double *weights,
                                size_t count,
                                double *out);

/**
 * Writes the logarithm of a unit motion. It has six components: the real part x y z,
 * which is half the angle times the axis, then the dual part x y z. What other
 * libraries call the logarithm, twice as large, is the twist that dq8_motion_to_twist
 * writes.
 */
dq8_status dq8_motion_log_f64(const double *motion, double *log);

/**
 * Writes the unit motion whose logarithm is `log`: six components, as dq8_motion_log
 * writes them. Of a twist, dq8_from_twist computes the motion.
 */
dq8_status dq8_motion_exp_f64(const double *log, double *out);

/**
 * Raises a unit motion to the power `t`. The power has the same screw axis, and t
 * times the angle and the slide.
 */
dq8_status dq8_motion_pow_f64(const double *motion, double t, double *out);

/**
 * Writes the screw of a unit motion as eight values. They are the direction x y z of
 * the axis, the moment x y z of the axis, the angle from 0 to pi, and the slide along
 * the axis. A translation has angle 0.
 */
dq8_status dq8_motion_to_screw_f64(const double *motion, double *screw);

/**
 * Writes the motion of a screw, which `numbers` gives as eight values. They are the
 * direction x y z of the axis, of length 1, the moment x y z of the axis, at right
 * angles to the direction, the angle, and the slide along the axis.
 */
dq8_status dq8_motion_from_screw_f64(const double *numbers, double *out);

/**
 * Makes a skin of the joints that move each vertex and their weights. It checks both
 * arrays once, so that the functions that pose the mesh need not. `joint_indices` and
 * `weights` hold `influences` elements per vertex, one vertex after the other. Fill
 * unused influences with any joint and weight 0. The skin points to both arrays, and
 * the behaviour of its functions is undefined if the program changes or frees them.
 *
 * Returns DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM if a vertex is wrong,
 * and sets `bad_vertex`, which may be null, to its index. Returns
 * DQ8_STATUS_NO_INFLUENCES if `influences` is 0. After an error the skin has not been
 * written.
 */
dq8_status dq8_skin_make_f32(size_t joint_count,
                             size_t influences,
                             const uint16_t *joint_indices,
                             const float *weights,
                             size_t vertices,
                             struct dq8_skin_f32 *skin,
                             size_t *bad_vertex);

/**
 * Makes a skin of a vertex buffer, otherwise like dq8_skin_make. `joint_indices` and
 * `weights` hold `stride` elements per vertex, of which the skin reads `influences`
 * elements from `first` on. Both pointers may be to the same memory. Divide strides
 * and offsets in bytes by the size of an element. Returns DQ8_STATUS_FIELD if a field
 * is not inside of its vertex.
 */
dq8_status dq8_skin_make_interleaved_f32(size_t joint_count,
                                         size_t influences,
                                         const uint16_t *joint_indices,
                                         struct dq8_influence_field joint_field,
                                         const float *weights,
                                         struct dq8_influence_field weight_field,
                                         size_t vertices,
                                         struct dq8_skin_f32 *skin,
                                         size_t *bad_vertex);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_linear_interleaved_f32(const struct dq8_skin_f32 *skin,
                                           const float *matrices,
                                           size_t joint_count,
                                           const float *rest,
                                           struct dq8_vertex_fields from,
                                           float *posed,
                                           struct dq8_vertex_fields to,
                                           size_t vertices);

/**
 * Poses a mesh by linear blends: each vertex moves by the weighted sum of its joints'
 * matrices. `matrices` is the palette, with twelve components per joint, row by row.
 * The weights of a vertex must sum to 1.
 *
 * `positions`, `normals` and `tangents` hold three components per vertex, of the mesh
 * at rest. The posed mesh is written to `posed_positions`, `posed_normals` and
 * `posed_tangents`, which must not overlap any other array. `normals` and
 * `posed_normals` may both be null, and so may `tangents` and `posed_tangents`.
 * Returns DQ8_STATUS_LENGTH_JOINTS or _LENGTH_VERTICES if `joint_count` or `vertices`
 * differs from that of the skin.
 */
dq8_status dq8_skin_linear_f32(const struct dq8_skin_f32 *skin,
                               const float *matrices,
                               size_t joint_count,
                               const float *positions,
                               const float *normals,
                               const float *tangents,
                               float *posed_positions,
                               float *posed_normals,
                               float *posed_tangents,
                               size_t vertices);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_dual_interleaved_f32(const struct dq8_skin_f32 *skin,
                                         const float *motions,
                                         size_t joint_count,
                                         const float *rest,
                                         struct dq8_vertex_fields from,
                                         float *posed,
                                         struct dq8_vertex_fields to,
                                         size_t vertices);

/**
 * Poses a mesh by dual quaternion blends, otherwise like dq8_skin_linear. Each vertex
 * moves by the normalized weighted sum of its joints' motions. Each motion gets the
 * sign that turns it toward the motion with the greatest weight. `motions` is the
 * palette, with eight components per joint. The mesh keeps its volume at twisted
 * joints.
 */
dq8_status dq8_skin_dual_f32(const struct dq8_skin_f32 *skin,
                             const float *motions,
                             size_t joint_count,
                             const float *positions,
                             const float *normals,
                             const float *tangents,
                             float *posed_positions,
                             float *posed_normals,
                             float *posed_tangents,
                             size_t vertices);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_stretched_interleaved_f32(const struct dq8_skin_f32 *skin,
                                              const float *motions,
                                              const float *stretches,
                                              size_t joint_count,
                                              const float *rest,
                                              struct dq8_vertex_fields from,
                                              float *posed,
                                              struct dq8_vertex_fields to,
                                              size_t vertices);

/**
 * Poses a mesh whose joints scale or shear, otherwise like dq8_skin_dual. The weighted
 * sum of its joints' `stretches` acts on each vertex before the motion does.
 * `stretches` are matrices of twelve components per joint. dq8_skin_split makes both
 * palettes.
 */
dq8_status dq8_skin_stretched_f32(const struct dq8_skin_f32 *skin,
                                  const float *motions,
                                  const float *stretches,
                                  size_t joint_count,
                                  const float *positions,
                                  const float *normals,
                                  const float *tangents,
                                  float *posed_positions,
                                  float *posed_normals,
                                  float *posed_tangents,
                                  size_t vertices);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_mixed_interleaved_f32(const struct dq8_skin_f32 *skin,
                                          const float *matrices,
                                          const float *motions,
                                          const float *shares,
                                          size_t joint_count,
                                          const float *rest,
                                          struct dq8_vertex_fields from,
                                          float *posed,
                                          struct dq8_vertex_fields to,
                                          size_t vertices);

/**
 * Poses a mesh by a mix of dq8_skin_linear and dq8_skin_dual. A posed vertex is (1 -
 * s) times the vertex of dq8_skin_linear plus s times the vertex of dq8_skin_dual.
 * This reduces the bulge of dual quaternion blends at bent joints. `shares` holds the
 * share s of each vertex. Returns DQ8_STATUS_SHARE if a share is not in [0, 1].
 */
dq8_status dq8_skin_mixed_f32(const struct dq8_skin_f32 *skin,
                              const float *matrices,
                              const float *motions,
                              const float *shares,
                              size_t joint_count,
                              const float *positions,
                              const float *normals,
                              const float *tangents,
                              float *posed_positions,
                              float *posed_normals,
                              float *posed_tangents,
                              size_t vertices);

/**
 * Makes a skin of the joints that move each vertex and their weights. It checks both
 * arrays once, so that the functions that pose the mesh need not. `joint_indices` and
 * `weights` hold `influences` elements per vertex, one vertex after the other. Fill
 * unused influences with any joint and weight 0. The skin points to both arrays, and
 * the behaviour of its functions is undefined if the program changes or frees them.
 *
 * Returns DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM if a vertex is wrong,
 * and sets `bad_vertex`, which may be null, to its index. Returns
 * DQ8_STATUS_NO_INFLUENCES if `influences` is 0. After an error the skin has not been
 * written.
 */
dq8_status dq8_skin_make_f64(size_t joint_count,
                             size_t influences,
                             const uint16_t *joint_indices,
                             const double *weights,
                             size_t vertices,
                             struct dq8_skin_f64 *skin,
                             size_t *bad_vertex);

/**
 * Makes a skin of a vertex buffer, otherwise like dq8_skin_make. `joint_indices` and
 * `weights` hold `stride` elements per vertex, of which the skin reads `influences`
 * elements from `first` on. Both pointers may be to the same memory. Divide strides
 * and offsets in bytes by the size of an element. Returns DQ8_STATUS_FIELD if a field
 * is not inside of its vertex.
 */
dq8_status dq8_skin_make_interleaved_f64(size_t joint_count,
                                         size_t influences,
                                         const uint16_t *joint_indices,
                                         struct dq8_influence_field joint_field,
                                         const double *weights,
                                         struct dq8_influence_field weight_field,
                                         size_t vertices,
                                         struct dq8_skin_f64 *skin,
                                         size_t *bad_vertex);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_linear_interleaved_f64(const struct dq8_skin_f64 *skin,
                                           const double *matrices,
                                           size_t joint_count,
                                           const double *rest,
                                           struct dq8_vertex_fields from,
                                           double *posed,
                                           struct dq8_vertex_fields to,
                                           size_t vertices);

/**
 * Poses a mesh by linear blends: each vertex moves by the weighted sum of its joints'
 * matrices. `matrices` is the palette, with twelve components per joint, row by row.
 * The weights of a vertex must sum to 1.
 *
 * `positions`, `normals` and `tangents` hold three components per vertex, of the mesh
 * at rest. The posed mesh is written to `posed_positions`, `posed_normals` and
 * `posed_tangents`, which must not overlap any other array. `normals` and
 * `posed_normals` may both be null, and so may `tangents` and `posed_tangents`.
 * Returns DQ8_STATUS_LENGTH_JOINTS or _LENGTH_VERTICES if `joint_count` or `vertices`
 * differs from that of the skin.
 */
dq8_status dq8_skin_linear_f64(const struct dq8_skin_f64 *skin,
                               const double *matrices,
                               size_t joint_count,
                               const double *positions,
                               const double *normals,
                               const double *tangents,
                               double *posed_positions,
                               double *posed_normals,
                               double *posed_tangents,
                               size_t vertices);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_dual_interleaved_f64(const struct dq8_skin_f64 *skin,
                                         const double *motions,
                                         size_t joint_count,
                                         const double *rest,
                                         struct dq8_vertex_fields from,
                                         double *posed,
                                         struct dq8_vertex_fields to,
                                         size_t vertices);

/**
 * Poses a mesh by dual quaternion blends, otherwise like dq8_skin_linear. Each vertex
 * moves by the normalized weighted sum of its joints' motions. Each motion gets the
 * sign that turns it toward the motion with the greatest weight. `motions` is the
 * palette, with eight components per joint. The mesh keeps its volume at twisted
 * joints.
 */
dq8_status dq8_skin_dual_f64(const struct dq8_skin_f64 *skin,
                             const double *motions,
                             size_t joint_count,
                             const double *positions,
                             const double *normals,
                             const double *tangents,
                             double *posed_positions,
                             double *posed_normals,
                             double *posed_tangents,
                             size_t vertices);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_stretched_interleaved_f64(const struct dq8_skin_f64 *skin,
                                              const double *motions,
                                              const double *stretches,
                                              size_t joint_count,
                                              const double *rest,
                                              struct dq8_vertex_fields from,
                                              double *posed,
                                              struct dq8_vertex_fields to,
                                              size_t vertices);

/**
 * Poses a mesh whose joints scale or shear, otherwise like dq8_skin_dual. The weighted
 * sum of its joints' `stretches` acts on each vertex before the motion does.
 * `stretches` are matrices of twelve components per joint. dq8_skin_split makes both
 * palettes.
 */
dq8_status dq8_skin_stretched_f64(const struct dq8_skin_f64 *skin,
                                  const double *motions,
                                  const double *stretches,
                                  size_t joint_count,
                                  const double *positions,
                                  const double *normals,
                                  const double *tangents,
                                  double *posed_positions,
                                  double *posed_normals,
                                  double *posed_tangents,
                                  size_t vertices);

/**
 * Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
 * and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
 * `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
 * other elements of `posed` keep their values.
 *
 * Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
 * and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
 * field.
 */
dq8_status dq8_skin_mixed_interleaved_f64(const struct dq8_skin_f64 *skin,
                                          const double *matrices,
                                          const double *motions,
                                          const double *shares,
                                          size_t joint_count,
                                          const double *rest,
                                          struct dq8_vertex_fields from,
                                          double *posed,
                                          struct dq8_vertex_fields to,
                                          size_t vertices);

/**
 * Poses a mesh by a mix of dq8_skin_linear and dq8_skin_dual. A posed vertex is (1 -
 * s) times the vertex of dq8_skin_linear plus s times the vertex of dq8_skin_dual.
 * This reduces the bulge of dual quaternion blends at bent joints. `shares` holds the
 * share s of each vertex. Returns DQ8_STATUS_SHARE if a share is not in [0, 1].
 */
dq8_status dq8_skin_mixed_f64(const struct dq8_skin_f64 *skin,
                              const double *matrices,
                              const double *motions,
                              const double *shares,
                              size_t joint_count,
                              const double *positions,
                              const double *normals,
                              const double *tangents,
                              double *posed_positions,
                              double *posed_normals,
                              double *posed_tangents,
                              size_t vertices);

/**
 * Computes the products `a[i] b[i]`, in which b acts first.
 * `out` may be `a`.
 */
dq8_status dq8_mul_f32(const float *a, const float *b, float *out, size_t count);

/**
 * Normalizes `motions` to unit motions, exactly; NaN where there is none.
 * `out` may be `motions`.
 */
dq8_status dq8_normalize_f32(const float *motions, float *out, size_t count);

/**
 * Computes the inverses of `motions` of any norm; NaN or infinite where there is none.
 * `out` may be `motions`.
 */
dq8_status dq8_inverse_f32(const float *motions, float *out, size_t count);

/**
 * Computes the inverses of unit `motions`, which only flips signs.
 * `out` may be `motions`.
 */
dq8_status dq8_conjugate_f32(const float *motions, float *out, size_t count);

/**
 * Interpolates linearly from `a[i]` (t = 0) to `b[i]` (t = 1) by the shorter way, and
 * normalizes.
 */
dq8_status dq8_nlerp_f32(const float *a, const float *b, float t, float *out, size_t count);

/**
 * Interpolates like `nlerp`, with a number `t[i]` for each pair.
 */
dq8_status dq8_nlerp_each_f32(const float *a,
                              const float *b,
                              const float *t,
                              float *out,
                              size_t count);

/**
 * Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1) by the shorter way, along
 * one screw at constant speed.
 */
dq8_status dq8_sclerp_f32(const float *a, const float *b, float t, float *out, size_t count);

/**
 * Interpolates like `sclerp`, with a number `t[i]` for each pair.
 */
dq8_status dq8_sclerp_each_f32(const float *a,
                               const float *b,
                               const float *t,
                               float *out,
                               size_t count);

/**
 * Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1): rotations turn at
 * constant speed, translations go straight.
 */
dq8_status dq8_slerp_lerp_f32(const float *a, const float *b, float t, float *out, size_t count);

/**
 * Interpolates like `slerp_lerp`, with a number `t[i]` for each pair.
 */
dq8_status dq8_slerp_lerp_each_f32(const float *a,
                                   const float *b,
                                   const float *t,
                                   float *out,
                                   size_t count);

/**
 * Raises the unit `motions[i]` to the power `t[i]`: the same screw axis, t times the
 * angle and the slide.
 */
dq8_status dq8_pow_each_f32(const float *motions, const float *t, float *out, size_t count);

/**
 * Computes the unit motions whose logarithms are `logs`, six numbers each.
 */
dq8_status dq8_exp_f32(const float *logs, float *out, size_t count);

/**
 * Computes the motions to which `twists`, six numbers each, angular part first, lead in
 * one second.
 */
dq8_status dq8_from_twist_f32(const float *twists, float *out, size_t count);

/**
 * Moves the unit `motions[i]` on by `dt` seconds of the body twists `twists[i]`, six
 * numbers each, angular part first.
 */
dq8_status dq8_integrate_body_f32(const float *motions,
                                  const float *twists,
                                  float dt,
                                  float *out,
                                  size_t count);

/**
 * Computes the logarithms of unit `motions`, six numbers each: half the angle times the
 * axis, and its moment. Twice that is the twist that leads there in one second.
 */
dq8_status dq8_log_f32(const float *motions, float *out, size_t count);

/**
 * Computes the twists, six numbers each, angular part first, that lead to unit `motions`
 * in one second.
 */
dq8_status dq8_to_twist_f32(const float *motions, float *out, size_t count);

/**
 * Computes the angles between unit `a[i]` and unit `b[i]`, radians in 0 to π, one number
 * each.
 */
dq8_status dq8_angles_f32(const float *a, const float *b, float *out, size_t count);

/**
 * Computes the distances between the translations of unit `a[i]` and unit `b[i]`, one
 * number each.
 */
dq8_status dq8_distances_f32(const float *a, const float *b, float *out, size_t count);

/**
 * Moves `points[i]`, three numbers each, by the unit `motions[i]`.
 */
dq8_status dq8_points_each_f32(const float *motions, const float *points, float *out, size_t count);

/**
 * Turns `vectors[i]`, three numbers each, by the unit `motions[i]`.
 */
dq8_status dq8_vectors_each_f32(const float *motions,
                                const float *vectors,
                                float *out,
                                size_t count);

/**
 * Moves `lines[i]` by the unit `motions[i]`. A line is six numbers: its direction, and
 * its moment p x direction of any point p on it (Plücker coordinates).
 */
dq8_status dq8_lines_each_f32(const float *motions, const float *lines, float *out, size_t count);

/**
 * Moves `planes[i]` by the unit `motions[i]`. A plane is four numbers: its unit normal
 * n, and n . p of any point p on it.
 */
dq8_status dq8_planes_each_f32(const float *motions, const float *planes, float *out, size_t count);

/**
 * Applies the adjoint of the unit `motions[i]` to `twists[i]`, six numbers, angular part
 * first, which turns a body twist into the spatial one.
 */
dq8_status dq8_twists_each_f32(const float *motions, const float *twists, float *out, size_t count);

/**
 * Moves `points`, three components each, by one unit `motion`. `out` may be `points`.
 */
dq8_status dq8_points_f32(const float *motion, const float *points, float *out, size_t count);

/**
 * Does what dq8_points_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_points_f32(size_t lanes,
                                 const float *motion,
                                 const float *points,
                                 float *out,
                                 size_t count);

/**
 * Turns `vectors`, three components each, by one unit `motion`. Vectors are
 * directions, which the motion does not translate. `out` may be `vectors`.
 */
dq8_status dq8_vectors_f32(const float *motion, const float *vectors, float *out, size_t count);

/**
 * Does what dq8_vectors_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_vectors_f32(size_t lanes,
                                  const float *motion,
                                  const float *vectors,
                                  float *out,
                                  size_t count);

/**
 * Writes the matrices `[R | t]` of unit `motions`. A matrix has twelve components in
 * `order`, one of enum dq8_matrix_order.
 */
dq8_status dq8_matrices_3x4_f32(const float *motions, int32_t order, float *out, size_t count);

/**
 * Does what dq8_matrices_3x4_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_matrices_3x4_f32(size_t lanes,
                                       const float *motions,
                                       int32_t order,
                                       float *out,
                                       size_t count);

/**
 * Writes the 4x4 matrices of unit `motions`, with the last row 0 0 0 1. A matrix has
 * sixteen components in `order`, one of enum dq8_matrix_order.
 */
dq8_status dq8_matrices_4x4_f32(const float *motions, int32_t order, float *out, size_t count);

/**
 * Does what dq8_matrices_4x4_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_matrices_4x4_f32(size_t lanes,
                                       const float *motions,
                                       int32_t order,
                                       float *out,
                                       size_t count);

/**
 * Does what dq8_mul_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_mul_f32(size_t lanes,
                              const float *a,
                              const float *b,
                              float *out,
                              size_t count);

/**
 * Does what dq8_normalize_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_normalize_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * Does what dq8_inverse_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_inverse_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * Does what dq8_conjugate_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_conjugate_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * Does what dq8_nlerp_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_nlerp_f32(size_t lanes,
                                const float *a,
                                const float *b,
                                float t,
                                float *out,
                                size_t count);

/**
 * Does what dq8_nlerp_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_nlerp_each_f32(size_t lanes,
                                     const float *a,
                                     const float *b,
                                     const float *t,
                                     float *out,
                                     size_t count);

/**
 * Does what dq8_sclerp_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_sclerp_f32(size_t lanes,
                                 const float *a,
                                 const float *b,
                                 float t,
                                 float *out,
                                 size_t count);

/**
 * Does what dq8_sclerp_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_sclerp_each_f32(size_t lanes,
                                      const float *a,
                                      const float *b,
                                      const float *t,
                                      float *out,
                                      size_t count);

/**
 * Does what dq8_slerp_lerp_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_slerp_lerp_f32(size_t lanes,
                                     const float *a,
                                     const float *b,
                                     float t,
                                     float *out,
                                     size_t count);

/**
 * Does what dq8_slerp_lerp_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_slerp_lerp_each_f32(size_t lanes,
                                          const float *a,
                                          const float *b,
                                          const float *t,
                                          float *out,
                                          size_t count);

/**
 * Does what dq8_pow_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_pow_each_f32(size_t lanes,
                                   const float *motions,
                                   const float *t,
                                   float *out,
                                   size_t count);

/**
 * Does what dq8_exp_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_exp_f32(size_t lanes, const float *logs, float *out, size_t count);

/**
 * Does what dq8_from_twist_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_from_twist_f32(size_t lanes, const float *twists, float *out, size_t count);

/**
 * Does what dq8_integrate_body_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_integrate_body_f32(size_t lanes,
                                         const float *motions,
                                         const float *twists,
                                         float dt,
                                         float *out,
                                         size_t count);

/**
 * Does what dq8_log_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_log_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * Does what dq8_to_twist_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_to_twist_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * Does what dq8_angles_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_angles_f32(size_t lanes,
                                 const float *a,
                                 const float *b,
                                 float *out,
                                 size_t count);

/**
 * Does what dq8_distances_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_distances_f32(size_t lanes,
                                    const float *a,
                                    const float *b,
                                    float *out,
                                    size_t count);

/**
 * Does what dq8_points_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_points_each_f32(size_t lanes,
                                      const float *motions,
                                      const float *points,
                                      float *out,
                                      size_t count);

/**
 * Does what dq8_vectors_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_vectors_each_f32(size_t lanes,
                                       const float *motions,
                                       const float *vectors,
                                       float *out,
                                       size_t count);

/**
 * Does what dq8_lines_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_lines_each_f32(size_t lanes,
                                     const float *motions,
                                     const float *lines,
                                     float *out,
                                     size_t count);

/**
 * Does what dq8_planes_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_planes_each_f32(size_t lanes,
                                      const float *motions,
                                      const float *planes,
                                      float *out,
                                      size_t count);

/**
 * Does what dq8_twists_each_f32 does, on blocks of 8 or 16 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_twists_each_f32(size_t lanes,
                                      const float *motions,
                                      const float *twists,
                                      float *out,
                                      size_t count);

/**
 * Computes the products `a[i] b[i]`, in which b acts first.
 * `out` may be `a`.
 */
dq8_status dq8_mul_f64(const double *a, const double *b, double *out, size_t count);

/**
 * Normalizes `motions` to unit motions, exactly; NaN where there is none.
 * `out` may be `motions`.
 */
dq8_status dq8_normalize_f64(const double *motions, double *out, size_t count);

/**
 * Computes the inverses of `motions` of any norm; NaN or infinite where there is none.
 * `out` may be `motions`.
 */
dq8_status dq8_inverse_f64(const double *motions, double *out, size_t count);

/**
 * Computes the inverses of unit `motions`, which only flips signs.
 * `out` may be `motions`.
 */
dq8_status dq8_conjugate_f64(const double *motions, double *out, size_t count);

/**
 * Interpolates linearly from `a[i]` (t = 0) to `b[i]` (t = 1) by the shorter way, and
 * normalizes.
 */
dq8_status dq8_nlerp_f64(const double *a, const double *b, double t, double *out, size_t count);

/**
 * Interpolates like `nlerp`, with a number `t[i]` for each pair.
 */
dq8_status dq8_nlerp_each_f64(const double *a,
                              const double *b,
                              const double *t,
                              double *out,
                              size_t count);

/**
 * Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1) by the shorter way, along
 * one screw at constant speed.
 */
dq8_status dq8_sclerp_f64(const double *a, const double *b, double t, double *out, size_t count);

/**
 * Interpolates like `sclerp`, with a number `t[i]` for each pair.
 */
dq8_status dq8_sclerp_each_f64(const double *a,
                               const double *b,
                               const double *t,
                               double *out,
                               size_t count);

/**
 * Interpolates from unit `a[i]` (t = 0) to unit `b[i]` (t = 1): rotations turn at
 * constant speed, translations go straight.
 */
dq8_status dq8_slerp_lerp_f64(const double *a,
                              const double *b,
                              double t,
                              double *out,
                              size_t count);

/**
 * Interpolates like `slerp_lerp`, with a number `t[i]` for each pair.
 */
dq8_status dq8_slerp_lerp_each_f64(const double *a,
                                   const double *b,
                                   const double *t,
                                   double *out,
                                   size_t count);

/**
 * Raises the unit `motions[i]` to the power `t[i]`: the same screw axis, t times the
 * angle and the slide.
 */
dq8_status dq8_pow_each_f64(const double *motions, const double *t, double *out, size_t count);

/**
 * Computes the unit motions whose logarithms are `logs`, six numbers each.
 */
dq8_status dq8_exp_f64(const double *logs, double *out, size_t count);

/**
 * Computes the motions to which `twists`, six numbers each, angular part first, lead in
 * one second.
 */
dq8_status dq8_from_twist_f64(const double *twists, double *out, size_t count);

/**
 * Moves the unit `motions[i]` on by `dt` seconds of the body twists `twists[i]`, six
 * numbers each, angular part first.
 */
dq8_status dq8_integrate_body_f64(const double *motions,
                                  const double *twists,
                                  double dt,
                                  double *out,
                                  size_t count);

/**
 * Computes the logarithms of unit `motions`, six numbers each: half the angle times the
 * axis, and its moment. Twice that is the twist that leads there in one second.
 */
dq8_status dq8_log_f64(const double *motions, double *out, size_t count);

/**
 * Computes the twists, six numbers each, angular part first, that lead to unit `motions`
 * in one second.
 */
dq8_status dq8_to_twist_f64(const double *motions, double *out, size_t count);

/**
 * Computes the angles between unit `a[i]` and unit `b[i]`, radians in 0 to π, one number
 * each.
 */
dq8_status dq8_angles_f64(const double *a, const double *b, double *out, size_t count);

/**
 * Computes the distances between the translations of unit `a[i]` and unit `b[i]`, one
 * number each.
 */
dq8_status dq8_distances_f64(const double *a, const double *b, double *out, size_t count);

/**
 * Moves `points[i]`, three numbers each, by the unit `motions[i]`.
 */
dq8_status dq8_points_each_f64(const double *motions,
                               const double *points,
                               double *out,
                               size_t count);

/**
 * Turns `vectors[i]`, three numbers each, by the unit `motions[i]`.
 */
dq8_status dq8_vectors_each_f64(const double *motions,
                                const double *vectors,
                                double *out,
                                size_t count);

/**
 * Moves `lines[i]` by the unit `motions[i]`. A line is six numbers: its direction, and
 * its moment p x direction of any point p on it (Plücker coordinates).
 */
dq8_status dq8_lines_each_f64(const double *motions,
                              const double *lines,
                              double *out,
                              size_t count);

/**
 * Moves `planes[i]` by the unit `motions[i]`. A plane is four numbers: its unit normal
 * n, and n . p of any point p on it.
 */
dq8_status dq8_planes_each_f64(const double *motions,
                               const double *planes,
                               double *out,
                               size_t count);

/**
 * Applies the adjoint of the unit `motions[i]` to `twists[i]`, six numbers, angular part
 * first, which turns a body twist into the spatial one.
 */
dq8_status dq8_twists_each_f64(const double *motions,
                               const double *twists,
                               double *out,
                               size_t count);

/**
 * Moves `points`, three components each, by one unit `motion`. `out` may be `points`.
 */
dq8_status dq8_points_f64(const double *motion, const double *points, double *out, size_t count);

/**
 * Does what dq8_points_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_points_f64(size_t lanes,
                                 const double *motion,
                                 const double *points,
                                 double *out,
                                 size_t count);

/**
 * Turns `vectors`, three components each, by one unit `motion`. Vectors are
 * directions, which the motion does not translate. `out` may be `vectors`.
 */
dq8_status dq8_vectors_f64(const double *motion, const double *vectors, double *out, size_t count);

/**
 * Does what dq8_vectors_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_vectors_f64(size_t lanes,
                                  const double *motion,
                                  const double *vectors,
                                  double *out,
                                  size_t count);

/**
 * Writes the matrices `[R | t]` of unit `motions`. A matrix has twelve components in
 * `order`, one of enum dq8_matrix_order.
 */
dq8_status dq8_matrices_3x4_f64(const double *motions, int32_t order, double *out, size_t count);

/**
 * Does what dq8_matrices_3x4_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_matrices_3x4_f64(size_t lanes,
                                       const double *motions,
                                       int32_t order,
                                       double *out,
                                       size_t count);

/**
 * Writes the 4x4 matrices of unit `motions`, with the last row 0 0 0 1. A matrix has
 * sixteen components in `order`, one of enum dq8_matrix_order.
 */
dq8_status dq8_matrices_4x4_f64(const double *motions, int32_t order, double *out, size_t count);

/**
 * Does what dq8_matrices_4x4_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_matrices_4x4_f64(size_t lanes,
                                       const double *motions,
                                       int32_t order,
                                       double *out,
                                       size_t count);

/**
 * Does what dq8_mul_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_mul_f64(size_t lanes,
                              const double *a,
                              const double *b,
                              double *out,
                              size_t count);

/**
 * Does what dq8_normalize_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_normalize_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * Does what dq8_inverse_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_inverse_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * Does what dq8_conjugate_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_conjugate_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * Does what dq8_nlerp_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_nlerp_f64(size_t lanes,
                                const double *a,
                                const double *b,
                                double t,
                                double *out,
                                size_t count);

/**
 * Does what dq8_nlerp_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_nlerp_each_f64(size_t lanes,
                                     const double *a,
                                     const double *b,
                                     const double *t,
                                     double *out,
                                     size_t count);

/**
 * Does what dq8_sclerp_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_sclerp_f64(size_t lanes,
                                 const double *a,
                                 const double *b,
                                 double t,
                                 double *out,
                                 size_t count);

/**
 * Does what dq8_sclerp_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_sclerp_each_f64(size_t lanes,
                                      const double *a,
                                      const double *b,
                                      const double *t,
                                      double *out,
                                      size_t count);

/**
 * Does what dq8_slerp_lerp_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_slerp_lerp_f64(size_t lanes,
                                     const double *a,
                                     const double *b,
                                     double t,
                                     double *out,
                                     size_t count);

/**
 * Does what dq8_slerp_lerp_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_slerp_lerp_each_f64(size_t lanes,
                                          const double *a,
                                          const double *b,
                                          const double *t,
                                          double *out,
                                          size_t count);

/**
 * Does what dq8_pow_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_pow_each_f64(size_t lanes,
                                   const double *motions,
                                   const double *t,
                                   double *out,
                                   size_t count);

/**
 * Does what dq8_exp_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_exp_f64(size_t lanes, const double *logs, double *out, size_t count);

/**
 * Does what dq8_from_twist_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_from_twist_f64(size_t lanes, const double *twists, double *out, size_t count);

/**
 * Does what dq8_integrate_body_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_integrate_body_f64(size_t lanes,
                                         const double *motions,
                                         const double *twists,
                                         double dt,
                                         double *out,
                                         size_t count);

/**
 * Does what dq8_log_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_log_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * Does what dq8_to_twist_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_to_twist_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * Does what dq8_angles_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_angles_f64(size_t lanes,
                                 const double *a,
                                 const double *b,
                                 double *out,
                                 size_t count);

/**
 * Does what dq8_distances_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_distances_f64(size_t lanes,
                                    const double *a,
                                    const double *b,
                                    double *out,
                                    size_t count);

/**
 * Does what dq8_points_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_points_each_f64(size_t lanes,
                                      const double *motions,
                                      const double *points,
                                      double *out,
                                      size_t count);

/**
 * Does what dq8_vectors_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_vectors_each_f64(size_t lanes,
                                       const double *motions,
                                       const double *vectors,
                                       double *out,
                                       size_t count);

/**
 * Does what dq8_lines_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_lines_each_f64(size_t lanes,
                                     const double *motions,
                                     const double *lines,
                                     double *out,
                                     size_t count);

/**
 * Does what dq8_planes_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_planes_each_f64(size_t lanes,
                                      const double *motions,
                                      const double *planes,
                                      double *out,
                                      size_t count);

/**
 * Does what dq8_twists_each_f64 does, on blocks of 4 or 8 `lanes`. `count` is the number of blocks.
 */
dq8_status dq8_blocks_twists_each_f64(size_t lanes,
                                      const double *motions,
                                      const double *twists,
                                      double *out,
                                      size_t count);

/**
 * Writes the size that `scratch` of dq8_solutions must have. The size counts floats or
 * doubles. It depends on the mechanism only.
 */
dq8_status dq8_solutions_scratch_f32(const struct dq8_mechanism_f32 *mechanism,
                                     size_t *scratch_count);

/**
 * Finds all solutions of an arm of six hinges for `count` targets: the values of its
 * hinges that bring the link of `goal` to the target. Arms with a spherical wrist and
 * arms with three parallel axes are solved by formula, others by searches from many
 * starts. `targets` holds unit motions. `starts` holds six values for each target,
 * from the base up; solutions are sorted by their distance from them. The mechanism
 * may have other joints, which do not carry the link.
 *
 * Returns DQ8_STATUS_NOT_SIX_HINGES, or the errors of a goal that dq8_mechanism_reach
 * has; and DQ8_STATUS_NOT_FINITE or _NOT_UNIT for a target or a start, and then sets
 * `bad_target`, which may be null, to its index.
 */
dq8_status dq8_solutions_f32(const struct dq8_mechanism_f32 *mechanism,
                             const struct dq8_goal_f32 *goal,
                             const float *targets,
                             const float *starts,
                             float *scratch,
                             size_t scratch_count,
                             struct dq8_solution_list_f32 *found,
                             size_t count,
                             size_t *bad_target);

/**
 * Writes the size that `scratch` of dq8_solutions must have. The size counts floats or
 * doubles. It depends on the mechanism only.
 */
dq8_status dq8_solutions_scratch_f64(const struct dq8_mechanism_f64 *mechanism,
                                     size_t *scratch_count);

/**
 * Finds all solutions of an arm of six hinges for `count` targets: the values of its
 * hinges that bring the link of `goal` to the target. Arms with a spherical wrist and
 * arms with three parallel axes are solved by formula, others by searches from many
 * starts. `targets` holds unit motions. `starts` holds six values for each target,
 * from the base up; solutions are sorted by their distance from them. The mechanism
 * may have other joints, which do not carry the link.
 *
 * Returns DQ8_STATUS_NOT_SIX_HINGES, or the errors of a goal that dq8_mechanism_reach
 * has; and DQ8_STATUS_NOT_FINITE or _NOT_UNIT for a target or a start, and then sets
 * `bad_target`, which may be null, to its index.
 */
dq8_status dq8_solutions_f64(const struct dq8_mechanism_f64 *mechanism,
                             const struct dq8_goal_f64 *goal,
                             const double *targets,
                             const double *starts,
                             double *scratch,
                             size_t scratch_count,
                             struct dq8_solution_list_f64 *found,
                             size_t count,
                             size_t *bad_target);

/**
 * Returns the meaning of a status in English. The text lives as long as the program. If `status`
 * is no value of enum dq8_status, the text says so.
 */
const char *dq8_status_text(int32_t status);

/**
 * Writes the size that `scratch` of dq8_reach must have. The size counts floats or
 * doubles. It depends on the mechanism and the number of goals, and not on the number
 * of configurations. Returns DQ8_STATUS_TOO_LARGE if there are more than 1024 goals.
 */
dq8_status dq8_reach_scratch_f32(const struct dq8_mechanism_f32 *mechanism,
                                 size_t goal_count,
                                 size_t *scratch_count);

/**
 * Solves the inverse kinematics of `count` configurations. It computes several
 * configurations at a time on lanes, and each like dq8_mechanism_reach. `targets` is
 * `[configuration][goal]`. `values` is `[configuration][value]` and holds
 * `value_count` values altogether. `reports` holds one report per configuration.
 * Goals, posture and options are the same for all configurations.
 *
 * The result of a configuration does not depend on other configurations, so each
 * thread may compute a part of them. Each thread needs scratch of its own, of the size
 * that dq8_reach_scratch writes. Errors are those of dq8_mechanism_reach.
 */
dq8_status dq8_reach_f32(const struct dq8_mechanism_f32 *mechanism,
                         const struct dq8_goal_f32 *goals,
                         size_t goal_count,
                         const float *targets,
                         const float *posture,
                         const struct dq8_reach_options_f32 *options,
                         float *values,
                         size_t value_count,
                         float *scratch,
                         size_t scratch_count,
                         struct dq8_reach_report_f32 *reports,
                         size_t count);

/**
 * Writes the size that `scratch` of dq8_reach must have. The size counts floats or
 * doubles. It depends on the mechanism and the number of goals, and not on the number
 * of configurations. Returns DQ8_STATUS_TOO_LARGE if there are more than 1024 goals.
 */
dq8_status dq8_reach_scratch_f64(const struct dq8_mechanism_f64 *mechanism,
                                 size_t goal_count,
                                 size_t *scratch_count);

/**
 * Solves the inverse kinematics of `count` configurations. It computes several
 * configurations at a time on lanes, and each like dq8_mechanism_reach. `targets` is
 * `[configuration][goal]`. `values` is `[configuration][value]` and holds
 * `value_count` values altogether. `reports` holds one report per configuration.
 * Goals, posture and options are the same for all configurations.
 *
 * The result of a configuration does not depend on other configurations, so each
 * thread may compute a part of them. Each thread needs scratch of its own, of the size
 * that dq8_reach_scratch writes. Errors are those of dq8_mechanism_reach.
 */
dq8_status dq8_reach_f64(const struct dq8_mechanism_f64 *mechanism,
                         const struct dq8_goal_f64 *goals,
                         size_t goal_count,
                         const double *targets,
                         const double *posture,
                         const struct dq8_reach_options_f64 *options,
                         double *values,
                         size_t value_count,
                         double *scratch,
                         size_t scratch_count,
                         struct dq8_reach_report_f64 *reports,
                         size_t count);

/**
 * Samples a trajectory at other times. `times` and `poses` hold `pose_count` rising
 * times and the unit poses at these times. `at` holds `count` times, and `out` gets
 * the poses at them. The trajectory moves along one screw from each pose to the next,
 * by the shorter way. Before the first time it stays at the first pose, and after the
 * last time at the last pose.
 *
 * Returns DQ8_STATUS_TIMES if an element of `times` is not finite or not later than
 * the element before it, and DQ8_STATUS_NOT_FINITE if an element of `at` is NaN. In
 * both cases it sets `bad_time`, which may be null, to the index of the element.
 * Returns DQ8_STATUS_FEW_POSES if there is no pose.
 */
dq8_status dq8_resample_f32(const float *times,
                            const float *poses,
                            size_t pose_count,
                            const float *at,
                            float *out,
                            size_t count,
                            size_t *bad_time);

/**
 * Samples the poses and velocities of a trajectory at `count` times. The trajectory
 * has `pose_count` unit `poses` at rising `stamps` in seconds, and moves along one
 * screw from each pose to the next, by the shorter way. `out` gets the pose at each of
 * the `times`. `twists`, which may be null, gets the body twist at each time: angular
 * x y z, then linear x y z, per second. If `options` is null, times are in seconds,
 * results are in the world, and the moving body stands still before the first stamp
 * and after the last stamp.
 *
 * Returns DQ8_STATUS_TIMES if a stamp is not finite or not later than the stamp before
 * it, and DQ8_STATUS_OUTSIDE if the options refuse a time or the time of the frame. It
 * sets `bad_time`, which may be null, to the index of the stamp or time. Returns
 * DQ8_STATUS_FEW_POSES if there is no pose, or if there is only one pose and `outside`
 * is 1. The pose at a time that is NaN is NaN.
 */
dq8_status dq8_trajectory_sample_f32(const double *stamps,
                                     const double *poses,
                                     size_t pose_count,
                                     const struct dq8_trajectory_options *options,
                                     const double *times,
                                     float *out,
                                     float *twists,
                                     size_t count,
                                     size_t *bad_time);

/**
 * Moves points, which a moving body has measured, into one frame. The body measured
 * point i (x, y, z) in its own frame at `times[i]`, and the pose of the trajectory at
 * this time moves the point. The field `frame` of the options selects the frame of the
 * results. The result is a scan as if it had been measured at one moment. `moved` may
 * be `points`. Trajectory, options and errors are those of dq8_trajectory_sample.
 */
dq8_status dq8_trajectory_deskew_f32(const double *stamps,
                                     const double *poses,
                                     size_t pose_count,
                                     const struct dq8_trajectory_options *options,
                                     const double *times,
                                     const float *points,
                                     float *moved,
                                     size_t count,
                                     size_t *bad_time);

/**
 * Computes the inverse of dq8_trajectory_deskew: moves points of one frame into the
 * frame of the body, in which it would have measured point i at `times[i]`.
 */
dq8_status dq8_trajectory_skew_f32(const double *stamps,
                                   const double *poses,
                                   size_t pose_count,
                                   const struct dq8_trajectory_options *options,
                                   const double *times,
                                   const float *points,
                                   float *moved,
                                   size_t count,
                                   size_t *bad_time);

/**
 * Samples the poses of a cubic spline, and its twists, at `count` times. `out` gets
 * the pose at each of the `times`. `twists` gets the body twist at this time: angular
 * x y z, then linear x y z, per second. `accelerations` gets the derivative of the
 * body twist with respect to time. Either may be null. The spline has `control_count`
 * unit control poses, four or more. Control pose k belongs to the time start + every *
 * (k - 1), in seconds. `basis` is 0 for a B-spline, which passes near the control
 * poses, and 1 for a Catmull-Rom spline, which passes through all control poses but
 * the first and the last. Options are those of dq8_trajectory_sample.
 *
 * Returns DQ8_STATUS_TIMES if the interval is not positive, DQ8_STATUS_NOT_FINITE if a
 * control pose is not finite, and DQ8_STATUS_OUTSIDE if the options refuse a time. It
 * sets `bad_index`, which may be null, to the index of the control pose or time.
 * Returns DQ8_STATUS_FEW_POSES if there are fewer than four control poses.
 */
dq8_status dq8_spline_poses_f32(const double *control,
                                size_t control_count,
                                double start,
                                double every,
                                int32_t basis,
                                const struct dq8_trajectory_options *options,
                                const double *times,
                                float *out,
                                float *twists,
                                float *accelerations,
                                size_t count,
                                size_t *bad_index);

/**
 * Samples a trajectory at other times. `times` and `poses` hold `pose_count` rising
 * times and the unit poses at these times. `at` holds `count` times, and `out` gets
 * the poses at them. The trajectory moves along one screw from each pose to the next,
 * by the shorter way. Before the first time it stays at the first pose, and after the
 * last time at the last pose.
 *
 * Returns DQ8_STATUS_TIMES if an element of `times` is not finite or not later than
 * the element before it, and DQ8_STATUS_NOT_FINITE if an element of `at` is NaN. In
 * both cases it sets `bad_time`, which may be null, to the index of the element.
 * Returns DQ8_STATUS_FEW_POSES if there is no pose.
 */
dq8_status dq8_resample_f64(const double *times,
                            const double *poses,
                            size_t pose_count,
                            const double *at,
                            double *out,
                            size_t count,
                            size_t *bad_time);

/**
 * Samples the poses and velocities of a trajectory at `count` times. The trajectory
 * has `pose_count` unit `poses` at rising `stamps` in seconds, and moves along one
 * screw from each pose to the next, by the shorter way. `out` gets the pose at each of
 * the `times`. `twists`, which may be null, gets the body twist at each time: angular
 * x y z, then linear x y z, per second. If `options` is null, times are in seconds,
 * results are in the world, and the moving body stands still before the first stamp
 * and after the last stamp.
 *
 * Returns DQ8_STATUS_TIMES if a stamp is not finite or not later than the stamp before
 * it, and DQ8_STATUS_OUTSIDE if the options refuse a time or the time of the frame. It
 * sets `bad_time`, which may be null, to the index of the stamp or time. Returns
 * DQ8_STATUS_FEW_POSES if there is no pose, or if there is only one pose and `outside`
 * is 1. The pose at a time that is NaN is NaN.
 */
dq8_status dq8_trajectory_sample_f64(const double *stamps,
                                     const double *poses,
                                     size_t pose_count,
                                     const struct dq8_trajectory_options *options,
                                     const double *times,
                                     double *out,
                                     double *twists,
                                     size_t count,
                                     size_t *bad_time);

/**
 * Moves points, which a moving body has measured, into one frame. The body measured
 * point i (x, y, z) in its own frame at `times[i]`, and the pose of the trajectory at
 * this time moves the point. The field `frame` of the options selects the frame of the
 * results. The result is a scan as if it had been measured at one moment. `moved` may
 * be `points`. Trajectory, options and errors are those of dq8_trajectory_sample.
 */
dq8_status dq8_trajectory_deskew_f64(const double *stamps,
                                     const double *poses,
                                     size_t pose_count,
                                     const struct dq8_trajectory_options *options,
                                     const double *times,
                                     const double *points,
                                     double *moved,
                                     size_t count,
                                     size_t *bad_time);

/**
 * Computes the inverse of dq8_trajectory_deskew: moves points of one frame into the
 * frame of the body, in which it would have measured point i at `times[i]`.
 */
dq8_status dq8_trajectory_skew_f64(const double *stamps,
                                   const double *poses,
                                   size_t pose_count,
                                   const struct dq8_trajectory_options *options,
                                   const double *times,
                                   const double *points,
                                   double *moved,
                                   size_t count,
                                   size_t *bad_time);

/**
 * Samples the poses of a cubic spline, and its twists, at `count` times. `out` gets
 * the pose at each of the `times`. `twists` gets the body twist at this time: angular
 * x y z, then linear x y z, per second. `accelerations` gets the derivative of the
 * body twist with respect to time. Either may be null. The spline has `control_count`
 * unit control poses, four or more. Control pose k belongs to the time start + every *
 * (k - 1), in seconds. `basis` is 0 for a B-spline, which passes near the control
 * poses, and 1 for a Catmull-Rom spline, which passes through all control poses but
 * the first and the last. Options are those of dq8_trajectory_sample.
 *
 * Returns DQ8_STATUS_TIMES if the interval is not positive, DQ8_STATUS_NOT_FINITE if a
 * control pose is not finite, and DQ8_STATUS_OUTSIDE if the options refuse a time. It
 * sets `bad_index`, which may be null, to the index of the control pose or time.
 * Returns DQ8_STATUS_FEW_POSES if there are fewer than four control poses.
 */
dq8_status dq8_spline_poses_f64(const double *control,
                                size_t control_count,
                                double start,
                                double every,
                                int32_t basis,
                                const struct dq8_trajectory_options *options,
                                const double *times,
                                double *out,
                                double *twists,
                                double *accelerations,
                                size_t count,
                                size_t *bad_index);

#if defined(DQ8_URDF)
/**
 * Reads a URDF file, of which `text` holds `length` bytes, and writes how large its robot is:
 * `link_count` gets the number of links, and `names_size` the number of bytes that dq8_urdf_joints
 * writes to `names`.
 *
 * Returns DQ8_STATUS_URDF if the file describes no robot. Then `message`, which has room for
 * `message_size` bytes, gets a text that says which line is wrong and why, with a zero at the end.
 * It may be null if `message_size` is 0.
 */
dq8_status dq8_urdf_size(const uint8_t *text,
                         size_t length,
                         size_t *link_count,
                         size_t *names_size,
                         char *message,
                         size_t message_size);

/**
 * Reads the joints of a URDF file, of which `text` holds `length` bytes. `joints` gets
 * `link_count` joints, for dq8_mechanism_make; joint j carries link j, and link 0 is
 * the root of the file. `names` gets the names of all links, then of all values, each
 * with a zero after it, and holds `names_size` bytes. `names` may be null if
 * `names_size` is zero. Both numbers are those that dq8_urdf_size writes, and the
 * errors are the same.
 *
 * Returns DQ8_STATUS_LENGTH_JOINTS or _LENGTH_NAMES if `link_count` or `names_size` is
 * not the number that dq8_urdf_size has written.
 */
dq8_status dq8_urdf_joints_f32(const uint8_t *text,
                               size_t length,
                               struct dq8_joint_f32 *joints,
                               size_t link_count,
                               char *names,
                               size_t names_size,
                               char *message,
                               size_t message_size);

/**
 * Reads the joints of a URDF file, of which `text` holds `length` bytes. `joints` gets
 * `link_count` joints, for dq8_mechanism_make; joint j carries link j, and link 0 is
 * the root of the file. `names` gets the names of all links, then of all values, each
 * with a zero after it, and holds `names_size` bytes. `names` may be null if
 * `names_size` is zero. Both numbers are those that dq8_urdf_size writes, and the
 * errors are the same.
 *
 * Returns DQ8_STATUS_LENGTH_JOINTS or _LENGTH_NAMES if `link_count` or `names_size` is
 * not the number that dq8_urdf_size has written.
 */
dq8_status dq8_urdf_joints_f64(const uint8_t *text,
                               size_t length,
                               struct dq8_joint_f64 *joints,
                               size_t link_count,
                               char *names,
                               size_t names_size,
                               char *message,
                               size_t message_size);
#endif

/* A joint of this kind, which mimics no other and has no limits. */
static inline dq8_joint_f32 dq8_joint_of_kind_f32(int32_t kind, int32_t parent, const float *placement, const float *axis)
{
  dq8_joint_f32 joint;
  int i;
  joint.parent = parent;
  joint.kind = kind;
  for (i = 0; i < 8; i++) joint.placement[i] = placement ? placement[i] : (i == 3 ? 1.0f : 0.0f);
  for (i = 0; i < 3; i++) joint.axis[i] = axis ? axis[i] : 0.0f;
  joint.pitch = 0.0f;
  joint.mimics = 0;
  joint.leader = 0;
  joint.multiplier = 0.0f;
  joint.offset = 0.0f;
  joint.limited = 0;
  joint.limits[0] = 0.0f;
  joint.limits[1] = 0.0f;
  return joint;
}

/**
 * Returns a joint that does not move. `placement` may be null for the identity.
 */
static inline dq8_joint_f32 dq8_joint_fixed_f32(int32_t parent, const float *placement)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_FIXED, parent, placement, 0);
  return joint;
}

/**
 * Returns a joint that turns about `axis`. `placement` may be null for the identity.
 */
static inline dq8_joint_f32 dq8_joint_revolute_f32(int32_t parent, const float *placement, const float *axis)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_REVOLUTE, parent, placement, axis);
  return joint;
}

/**
 * Returns a joint that slides along `axis`. `placement` may be null for the identity.
 */
static inline dq8_joint_f32 dq8_joint_prismatic_f32(int32_t parent, const float *placement, const float *axis)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_PRISMATIC, parent, placement, axis);
  return joint;
}

/**
 * Returns a joint that turns about `axis` and slides along it by `pitch` per radian. `placement` may be null for the identity.
 */
static inline dq8_joint_f32 dq8_joint_screw_f32(int32_t parent, const float *placement, const float *axis, float pitch)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_SCREW, parent, placement, axis);
  joint.pitch = pitch;
  return joint;
}

/**
 * Returns a joint that slides at right angles to `axis` and turns about it. `placement` may be null for the identity.
 */
static inline dq8_joint_f32 dq8_joint_planar_f32(int32_t parent, const float *placement, const float *axis)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_PLANAR, parent, placement, axis);
  return joint;
}

/**
 * Returns a joint that moves freely. `placement` may be null for the identity.
 */
static inline dq8_joint_f32 dq8_joint_floating_f32(int32_t parent, const float *placement)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_FLOATING, parent, placement, 0);
  return joint;
}

/* A joint of this kind, which mimics no other and has no limits. */
static inline dq8_joint_f64 dq8_joint_of_kind_f64(int32_t kind, int32_t parent, const double *placement, const double *axis)
{
  dq8_joint_f64 joint;
  int i;
  joint.parent = parent;
  joint.kind = kind;
  for (i = 0; i < 8; i++) joint.placement[i] = placement ? placement[i] : (i == 3 ? 1.0 : 0.0);
  for (i = 0; i < 3; i++) joint.axis[i] = axis ? axis[i] : 0.0;
  joint.pitch = 0.0;
  joint.mimics = 0;
  joint.leader = 0;
  joint.multiplier = 0.0;
  joint.offset = 0.0;
  joint.limited = 0;
  joint.limits[0] = 0.0;
  joint.limits[1] = 0.0;
  return joint;
}

/**
 * Returns a joint that does not move. `placement` may be null for the identity.
 */
static inline dq8_joint_f64 dq8_joint_fixed_f64(int32_t parent, const double *placement)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_FIXED, parent, placement, 0);
  return joint;
}

/**
 * Returns a joint that turns about `axis`. `placement` may be null for the identity.
 */
static inline dq8_joint_f64 dq8_joint_revolute_f64(int32_t parent, const double *placement, const double *axis)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_REVOLUTE, parent, placement, axis);
  return joint;
}

/**
 * Returns a joint that slides along `axis`. `placement` may be null for the identity.
 */
static inline dq8_joint_f64 dq8_joint_prismatic_f64(int32_t parent, const double *placement, const double *axis)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_PRISMATIC, parent, placement, axis);
  return joint;
}

/**
 * Returns a joint that turns about `axis` and slides along it by `pitch` per radian. `placement` may be null for the identity.
 */
static inline dq8_joint_f64 dq8_joint_screw_f64(int32_t parent, const double *placement, const double *axis, double pitch)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_SCREW, parent, placement, axis);
  joint.pitch = pitch;
  return joint;
}

/**
 * Returns a joint that slides at right angles to `axis` and turns about it. `placement` may be null for the identity.
 */
static inline dq8_joint_f64 dq8_joint_planar_f64(int32_t parent, const double *placement, const double *axis)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_PLANAR, parent, placement, axis);
  return joint;
}

/**
 * Returns a joint that moves freely. `placement` may be null for the identity.
 */
static inline dq8_joint_f64 dq8_joint_floating_f64(int32_t parent, const double *placement)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_FLOATING, parent, placement, 0);
  return joint;
}

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* DQ8_H */
