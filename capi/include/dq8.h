/*
 * dq8: rigid motions as dual quaternions, many at a time. Generated from capi/src by capi/header.sh;
 * do not edit.
 *
 * A motion is eight numbers, px py pz pw qx qy qz qw: p + eq rotates by p, then translates by t,
 * where q = tp/2. In a product a * b it is b that acts first. Angles are radians, lengths your unit.
 *
 * Names.    dq8_motion_NAME: one motion. dq8_mechanism_NAME: one configuration of a mechanism.
 *           dq8_skin_NAME: a mesh. dq8_plan_NAME: one instance of a hierarchy, in the best order.
 *           dq8_clips_NAME: packed clips. dq8_trajectory_NAME, dq8_spline_NAME: poses over time.
 *           dq8_NAME: arrays of `count` things in all, plain. dq8_blocks_NAME: the same on blocks, the fastest
 *           way. Each for float (_f32) and for double (_f64); dq8_generic.h has one name for both (C11).
 * Blocks.   A block has `lanes` things, component after component: with 8 lanes, the eight px, then
 *           the eight py, and so on. Its size is rounded up to whole 64 bytes (dq8_block_size).
 *           float has blocks of 8 and 16 lanes, double of 4 and 8.
 * Errors.   Every call returns a dq8_status. Whatever it is but DQ8_STATUS_OK, nothing was written,
 *           except an index such as `bad_joint`, and the steps that were to be a mechanism.
 * Memory.   All of it is yours: the library allocates nothing but what dq8_resample, dq8_trajectory_NAME and
 *           dq8_spline_NAME need while they run, which firmware has not; it keeps no pointer
 *           after it returns; a dq8_mechanism keeps one to its steps, a dq8_skin two to its joints and
 *           weights, dq8_clips one to their bytes. What their functions do is undefined if that memory
 *           has changed or gone. A pointer may be null where the length of its array is 0.
 * Align.    That of the number type; blocks start at multiples of 64 bytes.
 * Aliasing. Inputs may overlap each other. An output overlaps nothing, be it an array or one thing such as
 *           a motion, a root or options, unless a function says that it may be one of the inputs: then
 *           exactly that array. Functions on one motion read all before
 *           they write, so there an output may lie anywhere.
 * Checked.  Null and misaligned pointers, overlaps and lengths give an error. Wrong numbers in arrays give
 *           wrong results, never a crash, but in memory that a mechanism, a skin or clips keep. That an array is
 *           as long as you say cannot be checked, nor that a motion is unit where one is asked for.
 * Threads.  The library has none: give each of yours its own part of the arrays, and every bit is the same. Calls
 *           do not know of each other; only dq8_backend_limit and dq8_set_reproducible are for all threads.
 */

/*
 * Contents, without _f32 and _f64.
 *
 * One motion
 *   dq8_motion_line                            A line moved by a unit motion
 *   dq8_motion_plane                           A plane moved by a unit motion
 *   dq8_motion_twist                           A twist, six numbers, angular part first, by the adjoint of a unit ...
 *   dq8_motion_to_twist                        The twist, six numbers, angular part first, that leads to a unit ...
 *   dq8_motion_integrate_body                  Where a unit motion is after `dt` seconds of a body twist, six ...
 *   dq8_motion_angle_to                        The angle between two unit motions, one number, radians in 0 to pi
 *   dq8_motion_distance_to                     The distance between the translations of two unit motions, one number
 *   dq8_motion_mean                            The intrinsic mean of `count` unit motions
 *   dq8_motion_identity                        The motion that moves nothing
 *   dq8_motion_from_rotation_translation       Rotate by the unit quaternion `rotation` (x, y, z, w), then move by ...
 *   dq8_motion_to_rotation_translation         The parts of a unit motion
 *   dq8_motion_from_matrix_3x4                 The motion of a matrix, twelve numbers, row after row
 *   dq8_motion_from_matrix_4x4                 As dq8_motion_from_matrix_3x4, of sixteen numbers; ...
 *   dq8_motion_to_matrix_3x4                   The matrix `[R | t]` of a unit motion
 *   dq8_motion_to_matrix_4x4                   The matrix of a unit motion with the row 0 0 0 1: sixteen numbers, ...
 *   dq8_motion_mul                             a * b
 *   dq8_motion_conjugate                       The inverse of a unit motion, which costs nothing but signs
 *   dq8_motion_inverse                         The inverse of a motion, unit or not; DQ8_STATUS_NO_INVERSE if ...
 *   dq8_motion_normalize                       The unit motion beside a dual quaternion, exactly; ...
 *   dq8_motion_check_unit                      DQ8_STATUS_NOT_UNIT if the norm of the motion is further from 1 ...
 *   dq8_motion_point                           A point, three numbers, moved by a unit motion
 *   dq8_motion_vector                          A direction, three numbers, turned by a unit motion
 *   dq8_motion_nlerp                           From `a` to `b` by the shorter way, `t` of it
 *   dq8_motion_sclerp                          From unit `a` to unit `b` by the shorter way, `t` of it, along one ...
 *   dq8_motion_blend                           The blend of `count` unit motions by `weights`, which need not sum ...
 *   dq8_motion_log                             The logarithm of a unit motion, six numbers
 *   dq8_motion_exp                             The motion of a logarithm of six numbers
 *   dq8_motion_pow                             `t` of a unit motion
 *   dq8_motion_to_screw                        The screw of a unit motion, eight numbers
 *   dq8_motion_from_screw                      The motion of a screw, eight numbers
 *
 * One instance of a hierarchy, in the best order
 *   dq8_plan_make                              Finds the order in which dq8_plan_local_to_model computes the ...
 *   dq8_plan_local_to_model                    As dq8_local_to_model, joint by joint in the `order` that ...
 *
 * Packed clips
 *   dq8_clips_make                             Finds packed clips in bytes of dq8's form, which the Rust and the ...
 *   dq8_clips_duration                         The time from the first frame of a clip to the last
 *   dq8_clips_place                            The frame of a clip before the time `at`, and how far it is from ...
 *   dq8_clips_to_model                         As dq8_local_to_model, of what lies `t[i]` of the way from the ...
 *
 * Poses at stamps
 *   dq8_trajectory_sample                      The unit poses of a trajectory at the `times`, `count` of them as ...
 *   dq8_trajectory_deskew                      Points, x y z, that the body of a trajectory measured, each at its ...
 *   dq8_trajectory_skew                        The inverse of dq8_trajectory_deskew
 *
 * A smooth curve by control poses
 *   dq8_spline_poses                           A cubic spline at the `times`, `count` of them as of `out` and, ...
 *
 * One configuration of a mechanism
 *   dq8_mechanism_make                         Checks `count` joints and makes a mechanism of them, once; its ...
 *   dq8_mechanism_link_poses                   Forward kinematics of one configuration
 *   dq8_mechanism_link_pose                    The pose of one link
 *   dq8_mechanism_link_jacobian                The geometric Jacobian of a link
 *   dq8_mechanism_reach_options                Fills in the options that serve most
 *   dq8_mechanism_reach_scratch                How many numbers `scratch` of dq8_mechanism_reach must have for so ...
 *   dq8_mechanism_reach                        Inverse kinematics of one configuration
 *
 * A joint of a mechanism, filled in
 *   dq8_joint_fixed                            A joint that does not move
 *   dq8_joint_revolute                         A joint that turns about `axis`
 *   dq8_joint_prismatic                        A joint that slides along `axis`
 *   dq8_joint_screw                            A joint that turns about `axis` and slides along it, `pitch` for ...
 *   dq8_joint_planar                           A joint that slides in the plane across `axis`, and turns about it
 *   dq8_joint_floating                         A joint that moves freely
 *
 * A mesh
 *   dq8_skin_products                          A palette of matrices, `matrices[j] = models[j] * inverse_binds[j]`
 *   dq8_skin_split                             Takes the matrices of a palette apart into stretches and, after ...
 *   dq8_skin_make                              Checks which joints move each vertex and how much, once; the ...
 *   dq8_skin_make_interleaved                  As dq8_skin_make, of joints and weights that lie between other ...
 *   dq8_skin_linear_interleaved                As without _interleaved, of vertices that are records of several ...
 *   dq8_skin_linear                            Poses a mesh by linear blends
 *   dq8_skin_dual_interleaved                  As without _interleaved, of vertices that are records of several ...
 *   dq8_skin_dual                              As dq8_skin_linear by dual quaternion blends
 *   dq8_skin_stretched_interleaved             As without _interleaved, of vertices that are records of several ...
 *   dq8_skin_stretched                         As dq8_skin_dual where joints scale or shear
 *   dq8_skin_mixed_interleaved                 As without _interleaved, of vertices that are records of several ...
 *   dq8_skin_mixed                             As dq8_skin_linear and dq8_skin_dual, mixed by a number per vertex ...
 *
 * Arrays: dq8_NAME plain, dq8_blocks_NAME in blocks of lanes
 *   dq8_chain_products                         `out[i] = links[0] * links[1] * ... * links[i]`
 *   dq8_local_to_model                         Model poses of all joints from local ones
 *   dq8_model_to_local                         Local poses of all joints from unit model ones, as ...
 *   dq8_rotations_to_model                     As dq8_local_to_model of `count` unit quaternions (x, y, z, w) in ...
 *   dq8_rotations_translations_to_model        As dq8_local_to_model of `locals` with seven numbers each
 *   dq8_palette                                As dq8_local_to_model, and in the same pass the skinning palette
 *   dq8_palette_matrices                       As dq8_palette with a palette of matrices `[R | t]`, twelve numbers ...
 *   dq8_lines_each                             `lines[i]` moved by the unit `motions[i]`
 *   dq8_planes_each                            `planes[i]` moved by the unit `motions[i]`
 *   dq8_link_poses                             Forward kinematics of many configurations
 *   dq8_angles                                 The angles between unit `a[i]` and unit `b[i]`, radians in 0 to pi, ...
 *   dq8_distances                              The distances between the translations of unit `a[i]` and unit ...
 *   dq8_mul                                    `out[i] = a[i] * b[i]`
 *   dq8_normalize                              The unit motions beside `motions`, NaN where there is none; ...
 *   dq8_inverse                                The inverses of `motions`, unit or not; NaN or infinite where there ...
 *   dq8_conjugate                              The inverses of unit `motions`, which cost nothing but signs
 *   dq8_nlerp                                  From `a[i]` to `b[i]` by the shorter way, `t` of it
 *   dq8_nlerp_each                             As dq8_nlerp with a number `t[i]` for each
 *   dq8_sclerp                                 From unit `a[i]` to unit `b[i]` by the shorter way, `t` of it, ...
 *   dq8_sclerp_each                            As dq8_sclerp with a number `t[i]` for each
 *   dq8_points                                 `points`, three numbers each, moved by the one unit `motion`
 *   dq8_vectors                                `vectors`, three numbers each, turned by the one unit `motion`
 *   dq8_points_each                            `points[i]`, three numbers each, moved by the unit `motions[i]`
 *   dq8_vectors_each                           `vectors[i]`, three numbers each, turned by the unit `motions[i]`
 *   dq8_matrices_3x4                           The matrices `[R | t]` of unit `motions`, twelve numbers each; ...
 *   dq8_matrices_4x4                           The matrices of unit `motions` with the row 0 0 0 1, sixteen ...
 *   dq8_twists_each                            `twists[i]`, six numbers, angular part first, by the adjoint of the ...
 *   dq8_integrate_body                         Where the unit `motions[i]` are after `dt` seconds of the body ...
 *   dq8_log                                    The logarithms of unit `motions`, six numbers each
 *   dq8_exp                                    The motions of `logs`, six numbers each
 *   dq8_pow_each                               The unit `motions[i]` to the power `t[i]`
 *
 * Arrays, plain, and the library itself
 *   dq8_backend_name                           The name of what computes now, for logs
 *   dq8_backend_limit                          From now on, in all threads, nothing better than `most` computes
 *   dq8_set_reproducible                       From now on, in all threads, whether results have the same bits on ...
 *   dq8_check_parents                          Whether `parents` is a hierarchy
 *   dq8_pack                                   Writes `poses`, `[instance][joint]`, into blocks of `lanes` ...
 *   dq8_unpack                                 Writes blocks into `poses`, the other way round; lanes beyond the ...
 *   dq8_pack_chain                             Writes a chain into blocks, a segment of `block_count` links in ...
 *   dq8_unpack_chain                           Writes blocks of a chain into `links`, the other way round
 *   dq8_block_size                             How many numbers one block takes that has `components` (8 in ...
 *   dq8_status_text                            What a status means, in English
 *   dq8_reach_scratch                          How many numbers `scratch` of dq8_reach must have for so many ...
 *   dq8_reach                                  dq8_mechanism_reach for `count` configurations, as many at a time ...
 *   dq8_resample                               A trajectory, the unit `poses` at the rising `times`, both ...
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
 * What became of a call. Unless it is DQ8_STATUS_OK, nothing has been written, except an index
 * such as `bad_joint` or `bad_vertex`, the steps that were to be a mechanism, and scratch.
 */
enum dq8_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * It is done.
   */
  DQ8_STATUS_OK = 0,
  /**
   * A pointer is null where there is something to read or to write.
   */
  DQ8_STATUS_NULL_POINTER = 1,
  /**
   * A pointer is not aligned: to its number type, or to 64 bytes for blocks.
   */
  DQ8_STATUS_MISALIGNED = 2,
  /**
   * An output overlaps an input, be it an array or one thing, or another output, and is not
   * exactly the array that it may be.
   */
  DQ8_STATUS_OVERLAP = 3,
  /**
   * An array would be larger than memory.
   */
  DQ8_STATUS_TOO_LARGE = 4,
  /**
   * Lengths do not fit each other, such as a `count` that is no multiple of the joints: it
   * counts all poses of all instances or configurations.
   */
  DQ8_STATUS_LENGTH = 5,
  /**
   * There are no blocks of so many lanes: float has 8 and 16, double 4 and 8.
   */
  DQ8_STATUS_LANES = 6,
  /**
   * The motion, or the placement of a joint, is not unit.
   */
  DQ8_STATUS_NOT_UNIT = 7,
  /**
   * There is no unit motion: the real part is zero, or a number is not finite.
   */
  DQ8_STATUS_NOT_NORMALIZABLE = 8,
  /**
   * There is no inverse: the real part is zero, or a number is not finite.
   */
  DQ8_STATUS_NO_INVERSE = 9,
  /**
   * The matrix scales or shears.
   */
  DQ8_STATUS_NOT_ORTHONORMAL = 10,
  /**
   * The matrix mirrors.
   */
  DQ8_STATUS_MIRRORS = 11,
  /**
   * The translation of the matrix, or a number of a joint, is not finite.
   */
  DQ8_STATUS_NOT_FINITE = 12,
  /**
   * The last row of the 4x4 matrix is not 0 0 0 1.
   */
  DQ8_STATUS_NOT_AFFINE = 13,
  /**
   * There is nothing to blend.
   */
  DQ8_STATUS_NO_INFLUENCES = 14,
  /**
   * A parent does not come before its child: a forward reference, or a cycle.
   */
  DQ8_STATUS_PARENT_NOT_BEFORE = 15,
  /**
   * A parent is no joint at all, nor -1.
   */
  DQ8_STATUS_PARENT_OUT_OF_RANGE = 16,
  /**
   * There are more joints than 32 bits can number.
   */
  DQ8_STATUS_TOO_MANY_JOINTS = 17,
  /**
   * A number stands for nothing: no backend, no order of matrices, no kind of joint, no
   * frame.
   */
  DQ8_STATUS_UNKNOWN_VALUE = 18,
  /**
   * An axis or normal is not of length 1.
   */
  DQ8_STATUS_AXIS = 19,
  /**
   * A joint cannot mimic that one: there is none, it mimics too, or one of the two has not
   * one value.
   */
  DQ8_STATUS_MIMIC = 20,
  /**
   * There is no such link.
   */
  DQ8_STATUS_NO_LINK = 21,
  /**
   * The mechanism has not been made.
   */
  DQ8_STATUS_NO_MECHANISM = 22,
  /**
   * A vertex follows a joint that the palette does not have.
   */
  DQ8_STATUS_JOINT_OUT_OF_RANGE = 23,
  /**
   * A weight is negative or not finite; or a goal has none, or there is no goal.
   */
  DQ8_STATUS_WEIGHT = 24,
  /**
   * The weights of a vertex, which should sum to one, sum to less than 1/1024 or more
   * than 1024.
   */
  DQ8_STATUS_WEIGHT_SUM = 25,
  /**
   * The skin has not been made.
   */
  DQ8_STATUS_NO_SKIN = 26,
  /**
   * Limits of a joint are not in order, or leave no value together with those of what mimics
   * it, or are angles that a float does not tell apart.
   */
  DQ8_STATUS_LIMITS = 27,
  /**
   * A field lies beyond its vertex, or in another field.
   */
  DQ8_STATUS_FIELD = 28,
  /**
   * The order of a plan is not one of these parents: it has not been made for them.
   */
  DQ8_STATUS_NO_PLAN = 29,
  /**
   * A share of a mix is not in [0, 1].
   */
  DQ8_STATUS_SHARE = 30,
  /**
   * No joint moves the link of a goal: only fixed ones carry it.
   */
  DQ8_STATUS_UNMOVED = 31,
  /**
   * The packed clips have not been made.
   */
  DQ8_STATUS_NO_CLIPS = 32,
  /**
   * Bytes are no packed clips.
   */
  DQ8_STATUS_NOT_CLIPS = 33,
  /**
   * A time is not later than the one before, or not finite.
   */
  DQ8_STATUS_TIMES = 34,
  /**
   * A time is before the first stamp of a trajectory or after the last one, where that is
   * refused, or is the frame's and not finite.
   */
  DQ8_STATUS_OUTSIDE = 35,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum dq8_status dq8_status;
#else
typedef int32_t dq8_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The instructions that kernels over arrays and blocks may use, in rising order.
 */
enum dq8_backend
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * What the library was built for: SSE2 on x86-64, NEON on aarch64, none on a Cortex-M.
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
   * No limit. Newer versions may know more than the others above.
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
 * In which order the numbers of a matrix lie in memory.
 */
enum dq8_matrix_order
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * Row after row: C arrays.
   */
  DQ8_MATRIX_ORDER_ROWS = 0,
  /**
   * Column after column: OpenGL, GPU buffers.
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
 * How a joint moves, in its own frame.
 */
enum dq8_joint_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * Not at all. No value.
   */
  DQ8_JOINT_KIND_FIXED = 0,
  /**
   * Turns about `axis`. One value, radians.
   */
  DQ8_JOINT_KIND_REVOLUTE = 1,
  /**
   * Slides along `axis`. One value, a length.
   */
  DQ8_JOINT_KIND_PRISMATIC = 2,
  /**
   * Turns about `axis` and slides along it, `pitch` for each radian. One value, radians.
   */
  DQ8_JOINT_KIND_SCREW = 3,
  /**
   * Slides in the plane across `axis`, then turns about it. Three values: x, y and the angle.
   * The axes of x and y are those of the joint's frame after the shortest rotation that takes z
   * to `axis`.
   */
  DQ8_JOINT_KIND_PLANAR = 4,
  /**
   * Moves freely. Seven values: a quaternion x y z w of any length but zero, and a translation.
   * Six rates: the body twist, angular first.
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
 * In which axes, and about which point, the columns of a Jacobian are.
 */
enum dq8_frame
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * The axes of the base, about its origin: spatial twists.
   */
  DQ8_FRAME_WORLD = 0,
  /**
   * The axes of the link, about its origin: body twists.
   */
  DQ8_FRAME_BODY = 1,
  /**
   * The axes of the base, about the origin of the link.
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
 * How a search ended.
 */
enum dq8_outcome
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * Both errors are within the tolerances.
   */
  DQ8_OUTCOME_CONVERGED = 0,
  /**
   * A target is farther away than the mechanism is long.
   */
  DQ8_OUTCOME_OUT_OF_REACH = 1,
  /**
   * No way led nearer, and a limit stands in the way.
   */
  DQ8_OUTCOME_AT_LIMITS = 2,
  /**
   * No way led nearer.
   */
  DQ8_OUTCOME_STALLED = 3,
  /**
   * The iterations ran out while the links still came nearer: more would help.
   */
  DQ8_OUTCOME_UNFINISHED = 4,
  /**
   * A target is not unit to 0.001, a number is not finite, or an option is negative or no
   * number, or max_step is 0: the values are untouched.
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
 * Clips of one skeleton, checked once. It may be copied and moved; the bytes that it was made of
 * must stay where they are, as they are.
 */
typedef struct dq8_clips {
  /**
   * How many joints the skeleton has. 0 in clips that have not been made, if they were zeroed.
   */
  size_t joints;
  /**
   * How many clips there are.
   */
  size_t clips;
  /**
   * Not for you.
   */
  const uint8_t *opaque[13];
} dq8_clips;

/**
 * A clip, and the frame after which an instance is: made by dq8_clips_place, and good for the same
 * clips.
 */
typedef struct dq8_place {
  /**
   * Not for you.
   */
  uint32_t numbers[6];
} dq8_place;

/**
 * Memory for a joint of a mechanism; what is in it is the library's business.
 */
typedef struct dq8_step_f32 {
  /**
   * Not for you.
   */
  float opaque[100];
} dq8_step_f32;

/**
 * A mechanism that has been made. It may be copied and moved; its steps must stay where they are.
 */
typedef struct dq8_mechanism_f32 {
  /**
   * How many links it has: one for each joint.
   */
  size_t links;
  /**
   * How many values a configuration has: those of joint 0, then those of joint 1, and so on.
   */
  size_t values;
  /**
   * How many rates, and columns of a Jacobian: as many as values, but six for a floating joint.
   */
  size_t rates;
  /**
   * Null in a mechanism that has not been made, if it was zeroed.
   */
  const struct dq8_step_f32 *steps;
  /**
   * Not for you.
   */
  const struct dq8_step_f32 *opaque[4];
} dq8_mechanism_f32;

/**
 * Memory for a joint of a mechanism; what is in it is the library's business.
 */
typedef struct dq8_step_f64 {
  /**
   * Not for you.
   */
  double opaque[100];
} dq8_step_f64;

/**
 * A mechanism that has been made. It may be copied and moved; its steps must stay where they are.
 */
typedef struct dq8_mechanism_f64 {
  /**
   * How many links it has: one for each joint.
   */
  size_t links;
  /**
   * How many values a configuration has: those of joint 0, then those of joint 1, and so on.
   */
  size_t values;
  /**
   * How many rates, and columns of a Jacobian: as many as values, but six for a floating joint.
   */
  size_t rates;
  /**
   * Null in a mechanism that has not been made, if it was zeroed.
   */
  const struct dq8_step_f64 *steps;
  /**
   * Not for you.
   */
  const struct dq8_step_f64 *opaque[4];
} dq8_mechanism_f64;

/**
 * How a link is joined to the one that carries it. Link j is what joint j carries.
 *
 * Fields that its kind does not name are not read; all may be 0.
 */
typedef struct dq8_joint_f32 {
  /**
   * The joint of the link that carries this one, which comes before it, or -1 for the base.
   */
  int32_t parent;
  /**
   * One of enum dq8_joint_kind.
   */
  int32_t kind;
  /**
   * The pose of the link in that of its parent where the joint is at zero: a motion, unit to
   * 0.001.
   */
  float placement[8];
  /**
   * The axis or, of a planar joint, the normal; of length 1 to 0.001.
   */
  float axis[3];
  /**
   * Of a screw, length for each radian: the lead of a thread over 2 pi.
   */
  float pitch;
  /**
   * 1 if the joint has no value of its own but `multiplier` times that of joint `leader`, plus
   * `offset`; else 0. Both must be of one value, and the leader have its own.
   */
  int32_t mimics;
  /**
   * The joint whose value it takes.
   */
  int32_t leader;
  /**
   * What that value is multiplied by.
   */
  float multiplier;
  /**
   * What is added.
   */
  float offset;
  /**
   * 1 if the joint, which must be of one value, has limits; else 0. Inverse kinematics keeps to
   * them, nothing else does.
   */
  int32_t limited;
  /**
   * The least and the largest value; infinite where there is no end.
   */
  float limits[2];
} dq8_joint_f32;

/**
 * How a link is joined to the one that carries it. Link j is what joint j carries.
 *
 * Fields that its kind does not name are not read; all may be 0.
 */
typedef struct dq8_joint_f64 {
  /**
   * The joint of the link that carries this one, which comes before it, or -1 for the base.
   */
  int32_t parent;
  /**
   * One of enum dq8_joint_kind.
   */
  int32_t kind;
  /**
   * The pose of the link in that of its parent where the joint is at zero: a motion, unit to
   * 0.001.
   */
  double placement[8];
  /**
   * The axis or, of a planar joint, the normal; of length 1 to 0.001.
   */
  double axis[3];
  /**
   * Of a screw, length for each radian: the lead of a thread over 2 pi.
   */
  double pitch;
  /**
   * 1 if the joint has no value of its own but `multiplier` times that of joint `leader`, plus
   * `offset`; else 0. Both must be of one value, and the leader have its own.
   */
  int32_t mimics;
  /**
   * The joint whose value it takes.
   */
  int32_t leader;
  /**
   * What that value is multiplied by.
   */
  double multiplier;
  /**
   * What is added.
   */
  double offset;
  /**
   * 1 if the joint, which must be of one value, has limits; else 0. Inverse kinematics keeps to
   * them, nothing else does.
   */
  int32_t limited;
  /**
   * The least and the largest value; infinite where there is no end.
   */
  double limits[2];
} dq8_joint_f64;

/**
 * When a search ends, and how it weighs. dq8_reach_options fills in what serves most.
 */
typedef struct dq8_reach_options_f32 {
  /**
   * The turn that may be left, radians.
   */
  float angular_tolerance;
  /**
   * The distance that may be left.
   */
  float linear_tolerance;
  /**
   * Steps and restarts together.
   */
  uint32_t max_iterations;
  /**
   * 1 to begin again from another configuration where the search got stuck; 0 to converge from
   * the given start only, to follow a target that moves.
   */
  uint32_t restarts;
  /**
   * How long a distance weighs as much as a radian; 0 for an eighth of the mechanism's length,
   * or where something floats or slides without end, of the longer way that it has to go.
   */
  float length_per_radian;
  /**
   * The most that a hinge turns in one step, radians; more than a turn is as much as one.
   */
  float max_step;
  /**
   * Damping at the target itself, radians; 0 reaches it fastest.
   */
  float damping;
} dq8_reach_options_f32;

/**
 * What is asked of a link: components of its error in the axes of its target, and how much each
 * weighs where not all can vanish. A weight of 0 leaves its component free.
 */
typedef struct dq8_goal_f32 {
  /**
   * The link.
   */
  size_t link;
  /**
   * Weights of the rotation about the target's x, y and z; not negative.
   */
  float angular[3];
  /**
   * Weights of the way along the target's x, y and z; not negative.
   */
  float linear[3];
  /**
   * The point of the link, in its frame, that is to be at the target; zero is its origin.
   */
  float point[3];
} dq8_goal_f32;

/**
 * The result of a search, judged by the values that are returned.
 */
typedef struct dq8_reach_report_f32 {
  /**
   * One of enum dq8_outcome.
   */
  int32_t outcome;
  /**
   * Steps and restarts together.
   */
  uint32_t iterations;
  /**
   * How many of them were restarts.
   */
  uint32_t restarts;
  /**
   * The largest turn that is left of what is asked for, radians.
   */
  float angular_error;
  /**
   * The largest distance.
   */
  float linear_error;
} dq8_reach_report_f32;

/**
 * When a search ends, and how it weighs. dq8_reach_options fills in what serves most.
 */
typedef struct dq8_reach_options_f64 {
  /**
   * The turn that may be left, radians.
   */
  double angular_tolerance;
  /**
   * The distance that may be left.
   */
  double linear_tolerance;
  /**
   * Steps and restarts together.
   */
  uint32_t max_iterations;
  /**
   * 1 to begin again from another configuration where the search got stuck; 0 to converge from
   * the given start only, to follow a target that moves.
   */
  uint32_t restarts;
  /**
   * How long a distance weighs as much as a radian; 0 for an eighth of the mechanism's length,
   * or where something floats or slides without end, of the longer way that it has to go.
   */
  double length_per_radian;
  /**
   * The most that a hinge turns in one step, radians; more than a turn is as much as one.
   */
  double max_step;
  /**
   * Damping at the target itself, radians; 0 reaches it fastest.
   */
  double damping;
} dq8_reach_options_f64;

/**
 * What is asked of a link: components of its error in the axes of its target, and how much each
 * weighs where not all can vanish. A weight of 0 leaves its component free.
 */
typedef struct dq8_goal_f64 {
  /**
   * The link.
   */
  size_t link;
  /**
   * Weights of the rotation about the target's x, y and z; not negative.
   */
  double angular[3];
  /**
   * Weights of the way along the target's x, y and z; not negative.
   */
  double linear[3];
  /**
   * The point of the link, in its frame, that is to be at the target; zero is its origin.
   */
  double point[3];
} dq8_goal_f64;

/**
 * The result of a search, judged by the values that are returned.
 */
typedef struct dq8_reach_report_f64 {
  /**
   * One of enum dq8_outcome.
   */
  int32_t outcome;
  /**
   * Steps and restarts together.
   */
  uint32_t iterations;
  /**
   * How many of them were restarts.
   */
  uint32_t restarts;
  /**
   * The largest turn that is left of what is asked for, radians.
   */
  double angular_error;
  /**
   * The largest distance.
   */
  double linear_error;
} dq8_reach_report_f64;

/**
 * Which joints move the vertices of a mesh, and how much. It may be copied and moved; the joints
 * and weights that it was made of must stay where they are, as they are.
 */
typedef struct dq8_skin_f32 {
  /**
   * How many vertices it has.
   */
  size_t vertices;
  /**
   * How many influences every vertex has. 0 in a skin that has not been made, if it was zeroed.
   */
  size_t influences;
  /**
   * How many joints its palettes have.
   */
  size_t joints;
  /**
   * Not for you.
   */
  const float *opaque[8];
} dq8_skin_f32;

/**
 * Where the joints of a vertex lie in an array that holds one vertex after the other, or its
 * weights; counted in elements of their own type.
 */
typedef struct dq8_influence_field {
  /**
   * From a vertex to the next.
   */
  size_t stride;
  /**
   * Where in a vertex the field begins.
   */
  size_t first;
} dq8_influence_field;

/**
 * Where the fields of a vertex lie in a buffer that holds one vertex after the other, all counted
 * in numbers. A field is three numbers.
 */
typedef struct dq8_vertex_fields {
  /**
   * From a vertex to the next.
   */
  size_t stride;
  /**
   * Where in a vertex its position begins.
   */
  int32_t position;
  /**
   * Where its normal begins; -1 if none is posed.
   */
  int32_t normal;
  /**
   * Where its tangent begins, without the sign of the bitangent; -1 if none is posed.
   */
  int32_t tangent;
} dq8_vertex_fields;

/**
 * Which joints move the vertices of a mesh, and how much. It may be copied and moved; the joints
 * and weights that it was made of must stay where they are, as they are.
 */
typedef struct dq8_skin_f64 {
  /**
   * How many vertices it has.
   */
  size_t vertices;
  /**
   * How many influences every vertex has. 0 in a skin that has not been made, if it was zeroed.
   */
  size_t influences;
  /**
   * How many joints its palettes have.
   */
  size_t joints;
  /**
   * Not for you.
   */
  const double *opaque[8];
} dq8_skin_f64;

/**
 * The clock of the times, the frame that results come out in, and what is outside the stamps.
 */
typedef struct dq8_trajectory_options {
  /**
   * The time t is the stamp origin + unit * t, in seconds; 0 and 1 for times in seconds.
   */
  double origin;
  /**
   * The seconds of a unit of the times, such as 1e-9.
   */
  double unit;
  /**
   * Before the first stamp and after the last one: 0 if the body stands there, 1 if it goes on
   * as it moved there, 2 if such a time is refused.
   */
  int32_t outside;
  /**
   * 0: the world. 1: the body at the first stamp, 2: at the last one, 3: at `time`. 4: a frame
   * with the pose `pose`.
   */
  int32_t frame;
  /**
   * In seconds, on the clock of the stamps.
   */
  double time;
  /**
   * Unit, in the world.
   */
  double pose[8];
} dq8_trajectory_options;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The name of what computes now, for logs: text that lives as long as the program.
 */
const char *dq8_backend_name(void);

/**
 * From now on, in all threads, nothing better than `most` computes: one of enum dq8_backend. What
 * the CPU lacks is passed over, so a limit is always safe.
 *
 * DQ8_STATUS_UNKNOWN_VALUE if `most` is no backend; the limit stays as it was.
 */
dq8_status dq8_backend_limit(int32_t most);

/**
 * From now on, in all threads, whether results have the same bits on every machine, for 1.0 to 1.5
 * times the time: 1 if they have, 0 if not, as they begin. It goes with every limit. Functions of
 * one motion have the same bits always.
 *
 * DQ8_STATUS_UNKNOWN_VALUE if it is neither, or 1 and the library was built without the feature
 * `reproducible`; nothing changes.
 */
dq8_status dq8_set_reproducible(int32_t reproducible);

/**
 * `out[i] = links[0] * links[1] * ... * links[i]`: the model poses of a chain, fast
 * where it has dozens of links. Blocks hold one chain, a segment in each lane, as
 * dq8_pack_chain writes them. `out` may be `links`.
 */
dq8_status dq8_chain_products_f32(const float *links, float *out, size_t count);

/**
 * dq8_chain_products_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_chain_products_f32(size_t lanes,
                                         const float *links,
                                         float *out,
                                         size_t count);

/**
 * `out[i] = links[0] * links[1] * ... * links[i]`: the model poses of a chain, fast
 * where it has dozens of links. Blocks hold one chain, a segment in each lane, as
 * dq8_pack_chain writes them. `out` may be `links`.
 */
dq8_status dq8_chain_products_f64(const double *links, double *out, size_t count);

/**
 * dq8_chain_products_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_chain_products_f64(size_t lanes,
                                         const double *links,
                                         double *out,
                                         size_t count);

/**
 * Finds packed clips in bytes of dq8's form, which the Rust and the Python package and the example
 * mocap write. Reads all of them once.
 *
 * DQ8_STATUS_NOT_CLIPS if they are none; `bad_offset` is set to the first byte that is wrong, and
 * may be null.
 */
dq8_status dq8_clips_make(const uint8_t *bytes,
                          size_t length,
                          struct dq8_clips *clips,
                          size_t *bad_offset);

/**
 * The time from the first frame of a clip to the last: in seconds if the clip has a rate,
 * otherwise in frames. DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
 */
dq8_status dq8_clips_duration(const struct dq8_clips *clips, size_t clip, double *duration);

/**
 * The frame of a clip before the time `at`, and how far it is from that frame to the
 * next, from 0 to 1. Times are seconds if the clip has a rate, and frames if it has
 * none. Before its first frame and after its last one a clip stays there, or is in
 * another round if it loops. DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
 */
dq8_status dq8_clips_place_f32(const struct dq8_clips *clips,
                               size_t clip,
                               float at,
                               struct dq8_place *place,
                               float *t);

/**
 * As dq8_local_to_model, of what lies `t[i]` of the way from the frame of `places[i]`
 * to the next one: t is cut to [0, 1], and NaN makes models of NaN. `models` are
 * `[instance][joint]`, `joint_count` times `instances` in all. DQ8_STATUS_LENGTH if
 * the clips have another number of joints, or a place is one of other clips.
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
 * The frame of a clip before the time `at`, and how far it is from that frame to the
 * next, from 0 to 1. Times are seconds if the clip has a rate, and frames if it has
 * none. Before its first frame and after its last one a clip stays there, or is in
 * another round if it loops. DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
 */
dq8_status dq8_clips_place_f64(const struct dq8_clips *clips,
                               size_t clip,
                               double at,
                               struct dq8_place *place,
                               double *t);

/**
 * As dq8_local_to_model, of what lies `t[i]` of the way from the frame of `places[i]`
 * to the next one: t is cut to [0, 1], and NaN makes models of NaN. `models` are
 * `[instance][joint]`, `joint_count` times `instances` in all. DQ8_STATUS_LENGTH if
 * the clips have another number of joints, or a place is one of other clips.
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
 * A line moved by a unit motion. It is six numbers: its direction, and its moment p x
 * direction of any point p on it (Plücker coordinates).
 */
dq8_status dq8_motion_line_f32(const float *motion, const float *line, float *out);

/**
 * A plane moved by a unit motion. It is four numbers: its unit normal n, and n . p of
 * any point p on it.
 */
dq8_status dq8_motion_plane_f32(const float *motion, const float *plane, float *out);

/**
 * A twist, six numbers, angular part first, by the adjoint of a unit motion: a body
 * twist becomes the spatial one.
 */
dq8_status dq8_motion_twist_f32(const float *motion, const float *twist, float *out);

/**
 * The twist, six numbers, angular part first, that leads to a unit motion in one
 * second.
 */
dq8_status dq8_motion_to_twist_f32(const float *motion, float *twist);

/**
 * Where a unit motion is after `dt` seconds of a body twist, six numbers, angular part
 * first.
 */
dq8_status dq8_motion_integrate_body_f32(const float *motion,
                                         const float *twist,
                                         float dt,
                                         float *out);

/**
 * The angle between two unit motions, one number, radians in 0 to pi.
 */
dq8_status dq8_motion_angle_to_f32(const float *a, const float *b, float *angle);

/**
 * The distance between the translations of two unit motions, one number.
 */
dq8_status dq8_motion_distance_to_f32(const float *a, const float *b, float *distance);

/**
 * A line moved by a unit motion. It is six numbers: its direction, and its moment p x
 * direction of any point p on it (Plücker coordinates).
 */
dq8_status dq8_motion_line_f64(const double *motion, const double *line, double *out);

/**
 * A plane moved by a unit motion. It is four numbers: its unit normal n, and n . p of
 * any point p on it.
 */
dq8_status dq8_motion_plane_f64(const double *motion, const double *plane, double *out);

/**
 * A twist, six numbers, angular part first, by the adjoint of a unit motion: a body
 * twist becomes the spatial one.
 */
dq8_status dq8_motion_twist_f64(const double *motion, const double *twist, double *out);

/**
 * The twist, six numbers, angular part first, that leads to a unit motion in one
 * second.
 */
dq8_status dq8_motion_to_twist_f64(const double *motion, double *twist);

/**
 * Where a unit motion is after `dt` seconds of a body twist, six numbers, angular part
 * first.
 */
dq8_status dq8_motion_integrate_body_f64(const double *motion,
                                         const double *twist,
                                         double dt,
                                         double *out);

/**
 * The angle between two unit motions, one number, radians in 0 to pi.
 */
dq8_status dq8_motion_angle_to_f64(const double *a, const double *b, double *angle);

/**
 * The distance between the translations of two unit motions, one number.
 */
dq8_status dq8_motion_distance_to_f64(const double *a, const double *b, double *distance);

/**
 * Whether `parents` is a hierarchy: `parents[j]` is the parent of joint j and comes before it, or
 * is -1. Every function that takes parents checks them too, in a pass that costs little beside its
 * work; this one also says where the fault is.
 *
 * If it is DQ8_STATUS_PARENT_NOT_BEFORE or _PARENT_OUT_OF_RANGE, `bad_joint` is set to the first
 * such joint; it may be null, and must not lie in `parents`.
 */
dq8_status dq8_check_parents(const int32_t *parents, size_t joints, size_t *bad_joint);

/**
 * Model poses of all joints from local ones:
 * `models[j] = models[parents[j]] * locals[j]`.
 *
 * `locals` and `models` are `[instance][joint]`, `count` motions in all: `joints`
 * times instances, which is `joints` for one instance; in blocks,
 * `[block of instances][joint]`, `joints` times the number of instances over `lanes`,
 * rounded up. DQ8_STATUS_LENGTH if `count` is no multiple of `joints`. `root` is what
 * joints without a parent stand on, or null. `models` may be `locals`.
 */
dq8_status dq8_local_to_model_f32(const int32_t *parents,
                                  size_t joints,
                                  const float *root,
                                  const float *locals,
                                  float *models,
                                  size_t count);

/**
 * dq8_local_to_model_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_local_to_model_f32(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const float *root,
                                         const float *locals,
                                         float *models,
                                         size_t count);

/**
 * Local poses of all joints from unit model ones, as dq8_local_to_model the other way
 * round. `locals` may be `models`.
 */
dq8_status dq8_model_to_local_f32(const int32_t *parents,
                                  size_t joints,
                                  const float *root,
                                  const float *models,
                                  float *locals,
                                  size_t count);

/**
 * dq8_model_to_local_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_model_to_local_f32(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const float *root,
                                         const float *models,
                                         float *locals,
                                         size_t count);

/**
 * As dq8_local_to_model of `count` unit quaternions (x, y, z, w) in all and `joints`
 * offsets of joints from their parents (x, y, z), the same for all instances: what
 * animation clips hold.
 */
dq8_status dq8_rotations_to_model_f32(const int32_t *parents,
                                      size_t joints,
                                      const float *root,
                                      const float *rotations,
                                      const float *offsets,
                                      float *models,
                                      size_t count);

/**
 * dq8_rotations_to_model_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
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
 * As dq8_local_to_model of `locals` with seven numbers each: a unit quaternion (x, y,
 * z, w) and a translation (x, y, z).
 */
dq8_status dq8_rotations_translations_to_model_f32(const int32_t *parents,
                                                   size_t joints,
                                                   const float *root,
                                                   const float *locals,
                                                   float *models,
                                                   size_t count);

/**
 * dq8_rotations_translations_to_model_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_rotations_translations_to_model_f32(size_t lanes,
                                                          const int32_t *parents,
                                                          size_t joints,
                                                          const float *root,
                                                          const float *locals,
                                                          float *models,
                                                          size_t count);

/**
 * As dq8_local_to_model, and in the same pass the skinning palette:
 * `palette[j] = models[j] * inverse_binds[j]`, which takes a vertex of the mesh at
 * rest to where joint j has moved it.
 *
 * `inverse_binds` holds `joints` plain motions, the same for all instances. `models`
 * and `palette` hold `count` motions in all, as there, and must overlap nothing.
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
 * dq8_palette_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
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
 * As dq8_palette with a palette of matrices `[R | t]`, twelve numbers each, row after
 * row.
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
 * dq8_palette_matrices_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
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
 * Model poses of all joints from local ones:
 * `models[j] = models[parents[j]] * locals[j]`.
 *
 * `locals` and `models` are `[instance][joint]`, `count` motions in all: `joints`
 * times instances, which is `joints` for one instance; in blocks,
 * `[block of instances][joint]`, `joints` times the number of instances over `lanes`,
 * rounded up. DQ8_STATUS_LENGTH if `count` is no multiple of `joints`. `root` is what
 * joints without a parent stand on, or null. `models` may be `locals`.
 */
dq8_status dq8_local_to_model_f64(const int32_t *parents,
                                  size_t joints,
                                  const double *root,
                                  const double *locals,
                                  double *models,
                                  size_t count);

/**
 * dq8_local_to_model_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_local_to_model_f64(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const double *root,
                                         const double *locals,
                                         double *models,
                                         size_t count);

/**
 * Local poses of all joints from unit model ones, as dq8_local_to_model the other way
 * round. `locals` may be `models`.
 */
dq8_status dq8_model_to_local_f64(const int32_t *parents,
                                  size_t joints,
                                  const double *root,
                                  const double *models,
                                  double *locals,
                                  size_t count);

/**
 * dq8_model_to_local_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_model_to_local_f64(size_t lanes,
                                         const int32_t *parents,
                                         size_t joints,
                                         const double *root,
                                         const double *models,
                                         double *locals,
                                         size_t count);

/**
 * As dq8_local_to_model of `count` unit quaternions (x, y, z, w) in all and `joints`
 * offsets of joints from their parents (x, y, z), the same for all instances: what
 * animation clips hold.
 */
dq8_status dq8_rotations_to_model_f64(const int32_t *parents,
                                      size_t joints,
                                      const double *root,
                                      const double *rotations,
                                      const double *offsets,
                                      double *models,
                                      size_t count);

/**
 * dq8_rotations_to_model_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
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
 * As dq8_local_to_model of `locals` with seven numbers each: a unit quaternion (x, y,
 * z, w) and a translation (x, y, z).
 */
dq8_status dq8_rotations_translations_to_model_f64(const int32_t *parents,
                                                   size_t joints,
                                                   const double *root,
                                                   const double *locals,
                                                   double *models,
                                                   size_t count);

/**
 * dq8_rotations_translations_to_model_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_rotations_translations_to_model_f64(size_t lanes,
                                                          const int32_t *parents,
                                                          size_t joints,
                                                          const double *root,
                                                          const double *locals,
                                                          double *models,
                                                          size_t count);

/**
 * As dq8_local_to_model, and in the same pass the skinning palette:
 * `palette[j] = models[j] * inverse_binds[j]`, which takes a vertex of the mesh at
 * rest to where joint j has moved it.
 *
 * `inverse_binds` holds `joints` plain motions, the same for all instances. `models`
 * and `palette` hold `count` motions in all, as there, and must overlap nothing.
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
 * dq8_palette_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
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
 * As dq8_palette with a palette of matrices `[R | t]`, twelve numbers each, row after
 * row.
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
 * dq8_palette_matrices_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
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
 * `lines[i]` moved by the unit `motions[i]`. A line is six numbers: its direction, and
 * its moment p x direction of any point p on it (Plücker coordinates).
 */
dq8_status dq8_lines_each_f32(const float *motions, const float *lines, float *out, size_t count);

/**
 * dq8_lines_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_lines_each_f32(size_t lanes,
                                     const float *motions,
                                     const float *lines,
                                     float *out,
                                     size_t count);

/**
 * `planes[i]` moved by the unit `motions[i]`. A plane is four numbers: its unit normal
 * n, and n . p of any point p on it.
 */
dq8_status dq8_planes_each_f32(const float *motions, const float *planes, float *out, size_t count);

/**
 * dq8_planes_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_planes_each_f32(size_t lanes,
                                      const float *motions,
                                      const float *planes,
                                      float *out,
                                      size_t count);

/**
 * `lines[i]` moved by the unit `motions[i]`. A line is six numbers: its direction, and
 * its moment p x direction of any point p on it (Plücker coordinates).
 */
dq8_status dq8_lines_each_f64(const double *motions,
                              const double *lines,
                              double *out,
                              size_t count);

/**
 * dq8_lines_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_lines_each_f64(size_t lanes,
                                     const double *motions,
                                     const double *lines,
                                     double *out,
                                     size_t count);

/**
 * `planes[i]` moved by the unit `motions[i]`. A plane is four numbers: its unit normal
 * n, and n . p of any point p on it.
 */
dq8_status dq8_planes_each_f64(const double *motions,
                               const double *planes,
                               double *out,
                               size_t count);

/**
 * dq8_planes_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_planes_each_f64(size_t lanes,
                                      const double *motions,
                                      const double *planes,
                                      double *out,
                                      size_t count);

/**
 * Forward kinematics of many configurations: `values` is `[configuration][value]`,
 * `value_count` numbers in all: values of the mechanism times configurations. `poses`
 * is `[configuration][link]`, `count` motions in all: links of the mechanism times
 * configurations.
 *
 * In blocks, `poses` is `[block of configurations][link]`, `count` blocks in all:
 * links times the number of configurations over `lanes`, rounded up; `values` are
 * plain, as above. Lanes without a configuration get the poses of values that are all
 * zero. DQ8_STATUS_LENGTH if `value_count` and `count` are not those of the same
 * configurations.
 */
dq8_status dq8_link_poses_f32(const struct dq8_mechanism_f32 *mechanism,
                              const float *values,
                              size_t value_count,
                              float *poses,
                              size_t count);

/**
 * dq8_link_poses_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_link_poses_f32(size_t lanes,
                                     const struct dq8_mechanism_f32 *mechanism,
                                     const float *values,
                                     size_t value_count,
                                     float *poses,
                                     size_t count);

/**
 * Forward kinematics of many configurations: `values` is `[configuration][value]`,
 * `value_count` numbers in all: values of the mechanism times configurations. `poses`
 * is `[configuration][link]`, `count` motions in all: links of the mechanism times
 * configurations.
 *
 * In blocks, `poses` is `[block of configurations][link]`, `count` blocks in all:
 * links times the number of configurations over `lanes`, rounded up; `values` are
 * plain, as above. Lanes without a configuration get the poses of values that are all
 * zero. DQ8_STATUS_LENGTH if `value_count` and `count` are not those of the same
 * configurations.
 */
dq8_status dq8_link_poses_f64(const struct dq8_mechanism_f64 *mechanism,
                              const double *values,
                              size_t value_count,
                              double *poses,
                              size_t count);

/**
 * dq8_link_poses_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_link_poses_f64(size_t lanes,
                                     const struct dq8_mechanism_f64 *mechanism,
                                     const double *values,
                                     size_t value_count,
                                     double *poses,
                                     size_t count);

/**
 * The intrinsic mean of `count` unit motions: the one from which the `weights`, null
 * for equal ones, of the screws to all of them cancel; found by steps from
 * dq8_motion_blend, `max_iterations` at most (32 serve), until one turns by no more
 * than `tolerance`, radians, and moves by no more than that part of the longest dual
 * part (1e-6 serves for float, 1e-14 for double). `converged`, which may be null, is
 * set to 1 if it came to that, or else to 0.
 *
 * The mean of moved motions is the moved mean. Where motions lie more than a quarter
 * of a turn from it, there may be several. DQ8_STATUS_NO_INFLUENCES if `count` is 0,
 * DQ8_STATUS_NOT_NORMALIZABLE if there is no mean.
 */
dq8_status dq8_motion_mean_f32(const float *motions,
                               const float *weights,
                               size_t count,
                               float tolerance,
                               uint32_t max_iterations,
                               float *out,
                               int32_t *converged);

/**
 * The intrinsic mean of `count` unit motions: the one from which the `weights`, null
 * for equal ones, of the screws to all of them cancel; found by steps from
 * dq8_motion_blend, `max_iterations` at most (32 serve), until one turns by no more
 * than `tolerance`, radians, and moves by no more than that part of the longest dual
 * part (1e-6 serves for float, 1e-14 for double). `converged`, which may be null, is
 * set to 1 if it came to that, or else to 0.
 *
 * The mean of moved motions is the moved mean. Where motions lie more than a quarter
 * of a turn from it, there may be several. DQ8_STATUS_NO_INFLUENCES if `count` is 0,
 * DQ8_STATUS_NOT_NORMALIZABLE if there is no mean.
 */
dq8_status dq8_motion_mean_f64(const double *motions,
                               const double *weights,
                               size_t count,
                               double tolerance,
                               uint32_t max_iterations,
                               double *out,
                               int32_t *converged);

/**
 * Checks `count` joints and makes a mechanism of them, once; its functions then only
 * compute. `steps`, as many as joints, is memory that the mechanism keeps using: what
 * its functions do is undefined if anything else has written it. `joints` are not
 * needed any more.
 *
 * DQ8_STATUS_PARENT_NOT_BEFORE, _PARENT_OUT_OF_RANGE, _NOT_UNIT (the placement),
 * _NOT_FINITE, _AXIS, _MIMIC, _LIMITS or _UNKNOWN_VALUE (the kind, `mimics` or
 * `limited`); `bad_joint`, which may be null, is set to that joint. `steps` may have
 * been written, the mechanism not.
 */
dq8_status dq8_mechanism_make_f32(const struct dq8_joint_f32 *joints,
                                  size_t count,
                                  struct dq8_step_f32 *steps,
                                  struct dq8_mechanism_f32 *mechanism,
                                  size_t *bad_joint);

/**
 * Forward kinematics of one configuration: the poses of all links in the frame of the
 * base, `poses[j] = poses[parent] * placement[j] * motion of joint j`. `value_count`
 * and `link_count` are those of the mechanism, or it is DQ8_STATUS_LENGTH.
 */
dq8_status dq8_mechanism_link_poses_f32(const struct dq8_mechanism_f32 *mechanism,
                                        const float *values,
                                        size_t value_count,
                                        float *poses,
                                        size_t link_count);

/**
 * The pose of one link: nothing but what carries it is computed. DQ8_STATUS_NO_LINK if
 * there is no such link.
 */
dq8_status dq8_mechanism_link_pose_f32(const struct dq8_mechanism_f32 *mechanism,
                                       const float *values,
                                       size_t value_count,
                                       size_t link,
                                       float *pose);

/**
 * The geometric Jacobian of a link: for each rate of the mechanism a column of six
 * numbers, angular velocity x y z, then linear velocity x y z, in `frame`, one of enum
 * dq8_frame. Columns of joints that do not carry the link are zero.
 *
 * `column_count` is the mechanism's number of rates. `pose`, the pose of the link, may
 * be null. DQ8_STATUS_NO_LINK if there is no such link.
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
 * Checks `count` joints and makes a mechanism of them, once; its functions then only
 * compute. `steps`, as many as joints, is memory that the mechanism keeps using: what
 * its functions do is undefined if anything else has written it. `joints` are not
 * needed any more.
 *
 * DQ8_STATUS_PARENT_NOT_BEFORE, _PARENT_OUT_OF_RANGE, _NOT_UNIT (the placement),
 * _NOT_FINITE, _AXIS, _MIMIC, _LIMITS or _UNKNOWN_VALUE (the kind, `mimics` or
 * `limited`); `bad_joint`, which may be null, is set to that joint. `steps` may have
 * been written, the mechanism not.
 */
dq8_status dq8_mechanism_make_f64(const struct dq8_joint_f64 *joints,
                                  size_t count,
                                  struct dq8_step_f64 *steps,
                                  struct dq8_mechanism_f64 *mechanism,
                                  size_t *bad_joint);

/**
 * Forward kinematics of one configuration: the poses of all links in the frame of the
 * base, `poses[j] = poses[parent] * placement[j] * motion of joint j`. `value_count`
 * and `link_count` are those of the mechanism, or it is DQ8_STATUS_LENGTH.
 */
dq8_status dq8_mechanism_link_poses_f64(const struct dq8_mechanism_f64 *mechanism,
                                        const double *values,
                                        size_t value_count,
                                        double *poses,
                                        size_t link_count);

/**
 * The pose of one link: nothing but what carries it is computed. DQ8_STATUS_NO_LINK if
 * there is no such link.
 */
dq8_status dq8_mechanism_link_pose_f64(const struct dq8_mechanism_f64 *mechanism,
                                       const double *values,
                                       size_t value_count,
                                       size_t link,
                                       double *pose);

/**
 * The geometric Jacobian of a link: for each rate of the mechanism a column of six
 * numbers, angular velocity x y z, then linear velocity x y z, in `frame`, one of enum
 * dq8_frame. Columns of joints that do not carry the link are zero.
 *
 * `column_count` is the mechanism's number of rates. `pose`, the pose of the link, may
 * be null. DQ8_STATUS_NO_LINK if there is no such link.
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
 * The angles between unit `a[i]` and unit `b[i]`, radians in 0 to pi, one number each.
 */
dq8_status dq8_angles_f32(const float *a, const float *b, float *out, size_t count);

/**
 * dq8_angles_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_angles_f32(size_t lanes,
                                 const float *a,
                                 const float *b,
                                 float *out,
                                 size_t count);

/**
 * The distances between the translations of unit `a[i]` and unit `b[i]`, one number
 * each.
 */
dq8_status dq8_distances_f32(const float *a, const float *b, float *out, size_t count);

/**
 * dq8_distances_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_distances_f32(size_t lanes,
                                    const float *a,
                                    const float *b,
                                    float *out,
                                    size_t count);

/**
 * The angles between unit `a[i]` and unit `b[i]`, radians in 0 to pi, one number each.
 */
dq8_status dq8_angles_f64(const double *a, const double *b, double *out, size_t count);

/**
 * dq8_angles_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_angles_f64(size_t lanes,
                                 const double *a,
                                 const double *b,
                                 double *out,
                                 size_t count);

/**
 * The distances between the translations of unit `a[i]` and unit `b[i]`, one number
 * each.
 */
dq8_status dq8_distances_f64(const double *a, const double *b, double *out, size_t count);

/**
 * dq8_distances_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_distances_f64(size_t lanes,
                                    const double *a,
                                    const double *b,
                                    double *out,
                                    size_t count);

/**
 * The motion that moves nothing.
 */
dq8_status dq8_motion_identity_f32(float *out);

/**
 * Rotate by the unit quaternion `rotation` (x, y, z, w), then move by `translation`
 * (x, y, z).
 */
dq8_status dq8_motion_from_rotation_translation_f32(const float *rotation,
                                                    const float *translation,
                                                    float *out);

/**
 * The parts of a unit motion: `rotation` four numbers, `translation` three, which must
 * not overlap each other.
 */
dq8_status dq8_motion_to_rotation_translation_f32(const float *motion,
                                                  float *rotation,
                                                  float *translation);

/**
 * The motion of a matrix, twelve numbers, row after row. `tolerance` is how far
 * products of rows of the rotation may be from 0 and 1.
 *
 * DQ8_STATUS_NOT_ORTHONORMAL, _MIRRORS or _NOT_FINITE if it is no rigid motion.
 */
dq8_status dq8_motion_from_matrix_3x4_f32(const float *matrix, float tolerance, float *out);

/**
 * As dq8_motion_from_matrix_3x4, of sixteen numbers; DQ8_STATUS_NOT_AFFINE if the last
 * row is not 0 0 0 1.
 */
dq8_status dq8_motion_from_matrix_4x4_f32(const float *matrix, float tolerance, float *out);

/**
 * The matrix `[R | t]` of a unit motion: twelve numbers, row after row.
 */
dq8_status dq8_motion_to_matrix_3x4_f32(const float *motion, float *matrix);

/**
 * The matrix of a unit motion with the row 0 0 0 1: sixteen numbers, row after row.
 */
dq8_status dq8_motion_to_matrix_4x4_f32(const float *motion, float *matrix);

/**
 * a * b: b acts first.
 */
dq8_status dq8_motion_mul_f32(const float *a, const float *b, float *out);

/**
 * The inverse of a unit motion, which costs nothing but signs.
 */
dq8_status dq8_motion_conjugate_f32(const float *motion, float *out);

/**
 * The inverse of a motion, unit or not; DQ8_STATUS_NO_INVERSE if there is none.
 */
dq8_status dq8_motion_inverse_f32(const float *motion, float *out);

/**
 * The unit motion beside a dual quaternion, exactly; DQ8_STATUS_NOT_NORMALIZABLE if
 * there is none.
 */
dq8_status dq8_motion_normalize_f32(const float *motion, float *out);

/**
 * DQ8_STATUS_NOT_UNIT if the norm of the motion is further from 1 than `tolerance`.
 */
dq8_status dq8_motion_check_unit_f32(const float *motion, float tolerance);

/**
 * A point, three numbers, moved by a unit motion.
 */
dq8_status dq8_motion_point_f32(const float *motion, const float *point, float *out);

/**
 * A direction, three numbers, turned by a unit motion.
 */
dq8_status dq8_motion_vector_f32(const float *motion, const float *vector, float *out);

/**
 * The motion that moves nothing.
 */
dq8_status dq8_motion_identity_f64(double *out);

/**
 * Rotate by the unit quaternion `rotation` (x, y, z, w), then move by `translation`
 * (x, y, z).
 */
dq8_status dq8_motion_from_rotation_translation_f64(const double *rotation,
                                                    const double *translation,
                                                    double *out);

/**
 * The parts of a unit motion: `rotation` four numbers, `translation` three, which must
 * not overlap each other.
 */
dq8_status dq8_motion_to_rotation_translation_f64(const double *motion,
                                                  double *rotation,
                                                  double *translation);

/**
 * The motion of a matrix, twelve numbers, row after row. `tolerance` is how far
 * products of rows of the rotation may be from 0 and 1.
 *
 * DQ8_STATUS_NOT_ORTHONORMAL, _MIRRORS or _NOT_FINITE if it is no rigid motion.
 */
dq8_status dq8_motion_from_matrix_3x4_f64(const double *matrix, double tolerance, double *out);

/**
 * As dq8_motion_from_matrix_3x4, of sixteen numbers; DQ8_STATUS_NOT_AFFINE if the last
 * row is not 0 0 0 1.
 */
dq8_status dq8_motion_from_matrix_4x4_f64(const double *matrix, double tolerance, double *out);

/**
 * The matrix `[R | t]` of a unit motion: twelve numbers, row after row.
 */
dq8_status dq8_motion_to_matrix_3x4_f64(const double *motion, double *matrix);

/**
 * The matrix of a unit motion with the row 0 0 0 1: sixteen numbers, row after row.
 */
dq8_status dq8_motion_to_matrix_4x4_f64(const double *motion, double *matrix);

/**
 * a * b: b acts first.
 */
dq8_status dq8_motion_mul_f64(const double *a, const double *b, double *out);

/**
 * The inverse of a unit motion, which costs nothing but signs.
 */
dq8_status dq8_motion_conjugate_f64(const double *motion, double *out);

/**
 * The inverse of a motion, unit or not; DQ8_STATUS_NO_INVERSE if there is none.
 */
dq8_status dq8_motion_inverse_f64(const double *motion, double *out);

/**
 * The unit motion beside a dual quaternion, exactly; DQ8_STATUS_NOT_NORMALIZABLE if
 * there is none.
 */
dq8_status dq8_motion_normalize_f64(const double *motion, double *out);

/**
 * DQ8_STATUS_NOT_UNIT if the norm of the motion is further from 1 than `tolerance`.
 */
dq8_status dq8_motion_check_unit_f64(const double *motion, double tolerance);

/**
 * A point, three numbers, moved by a unit motion.
 */
dq8_status dq8_motion_point_f64(const double *motion, const double *point, double *out);

/**
 * A direction, three numbers, turned by a unit motion.
 */
dq8_status dq8_motion_vector_f64(const double *motion, const double *vector, double *out);

/**
 * Writes `poses`, `[instance][joint]`, into blocks of `lanes` instances,
 * `[instance block][joint]`; lanes without an instance get the identity. `block_count`
 * is `joints` times the number of instances over `lanes`, rounded up;
 * DQ8_STATUS_LENGTH if it is not.
 */
dq8_status dq8_pack_f32(size_t lanes,
                        size_t joints,
                        const float *poses,
                        size_t pose_count,
                        float *blocks,
                        size_t block_count);

/**
 * Writes blocks into `poses`, the other way round; lanes beyond the last instance are
 * dropped.
 */
dq8_status dq8_unpack_f32(size_t lanes,
                          size_t joints,
                          const float *blocks,
                          size_t block_count,
                          float *poses,
                          size_t pose_count);

/**
 * Writes a chain into blocks, a segment of `block_count` links in each lane: link i is
 * in lane `i / block_count` of block `i % block_count`. Lanes beyond the last link get
 * the identity. `block_count` is `link_count` over `lanes`, rounded up;
 * DQ8_STATUS_LENGTH if it is not.
 */
dq8_status dq8_pack_chain_f32(size_t lanes,
                              const float *links,
                              size_t link_count,
                              float *blocks,
                              size_t block_count);

/**
 * Writes blocks of a chain into `links`, the other way round.
 */
dq8_status dq8_unpack_chain_f32(size_t lanes,
                                const float *blocks,
                                size_t block_count,
                                float *links,
                                size_t link_count);

/**
 * How many numbers one block takes that has `components` (8 in motions, 3 in points, 4 in
 * rotations, 7 in rotations with translations, 12 or 16 in matrices) of each of `lanes`
 * things: their product, rounded up to whole 64 bytes.
 */
size_t dq8_block_size_f32(size_t lanes, size_t components);

/**
 * Writes `poses`, `[instance][joint]`, into blocks of `lanes` instances,
 * `[instance block][joint]`; lanes without an instance get the identity. `block_count`
 * is `joints` times the number of instances over `lanes`, rounded up;
 * DQ8_STATUS_LENGTH if it is not.
 */
dq8_status dq8_pack_f64(size_t lanes,
                        size_t joints,
                        const double *poses,
                        size_t pose_count,
                        double *blocks,
                        size_t block_count);

/**
 * Writes blocks into `poses`, the other way round; lanes beyond the last instance are
 * dropped.
 */
dq8_status dq8_unpack_f64(size_t lanes,
                          size_t joints,
                          const double *blocks,
                          size_t block_count,
                          double *poses,
                          size_t pose_count);

/**
 * Writes a chain into blocks, a segment of `block_count` links in each lane: link i is
 * in lane `i / block_count` of block `i % block_count`. Lanes beyond the last link get
 * the identity. `block_count` is `link_count` over `lanes`, rounded up;
 * DQ8_STATUS_LENGTH if it is not.
 */
dq8_status dq8_pack_chain_f64(size_t lanes,
                              const double *links,
                              size_t link_count,
                              double *blocks,
                              size_t block_count);

/**
 * Writes blocks of a chain into `links`, the other way round.
 */
dq8_status dq8_unpack_chain_f64(size_t lanes,
                                const double *blocks,
                                size_t block_count,
                                double *links,
                                size_t link_count);

/**
 * How many numbers one block takes that has `components` (8 in motions, 3 in points, 4 in
 * rotations, 7 in rotations with translations, 12 or 16 in matrices) of each of `lanes`
 * things: their product, rounded up to whole 64 bytes.
 */
size_t dq8_block_size_f64(size_t lanes, size_t components);

/**
 * A palette of matrices, `matrices[j] = models[j] * inverse_binds[j]`: from 4x4
 * matrices in `order`, one of enum dq8_matrix_order, to twelve numbers per joint, row
 * after row.
 *
 * DQ8_STATUS_NOT_FINITE or _NOT_AFFINE if a matrix is.
 */
dq8_status dq8_skin_products_f32(const float *models,
                                 const float *inverse_binds,
                                 int32_t order,
                                 float *matrices,
                                 size_t joint_count);

/**
 * Takes the matrices of a palette apart into stretches and, after them, unit motions:
 * what dq8_skin_stretched takes. DQ8_STATUS_NOT_FINITE if a number is not finite.
 */
dq8_status dq8_skin_split_f32(const float *matrices,
                              float *motions,
                              float *stretches,
                              size_t joint_count);

/**
 * A palette of matrices, `matrices[j] = models[j] * inverse_binds[j]`: from 4x4
 * matrices in `order`, one of enum dq8_matrix_order, to twelve numbers per joint, row
 * after row.
 *
 * DQ8_STATUS_NOT_FINITE or _NOT_AFFINE if a matrix is.
 */
dq8_status dq8_skin_products_f64(const double *models,
                                 const double *inverse_binds,
                                 int32_t order,
                                 double *matrices,
                                 size_t joint_count);

/**
 * Takes the matrices of a palette apart into stretches and, after them, unit motions:
 * what dq8_skin_stretched takes. DQ8_STATUS_NOT_FINITE if a number is not finite.
 */
dq8_status dq8_skin_split_f64(const double *matrices,
                              double *motions,
                              double *stretches,
                              size_t joint_count);

/**
 * Finds the order in which dq8_plan_local_to_model computes the joints of one instance: those that
 * others wait for come early, and between a joint and its parent there are others.
 *
 * `order` has two numbers per joint, and must stay as it is while it is used; `scratch` six, which
 * are not needed afterwards. A bad parent is told as by dq8_check_parents, and `bad_joint` set to
 * it, which may be null.
 */
dq8_status dq8_plan_make(const int32_t *parents,
                         size_t joints,
                         uint32_t *order,
                         uint32_t *scratch,
                         size_t *bad_joint);

/**
 * As dq8_local_to_model, joint by joint in the `order` that dq8_plan_make found for
 * the same parents, with the eight numbers of a motion in one register: the fastest
 * way for one instance. Several are computed as by dq8_local_to_model: `count` motions
 * in all, `joints` times instances. `models` may be `locals`.
 *
 * DQ8_STATUS_NO_PLAN if a pair of `order` is not a joint and its parent, or a root
 * stands behind other joints. An order whose pairs have changed places is not noticed.
 */
dq8_status dq8_plan_local_to_model_f32(const int32_t *parents,
                                       const uint32_t *order,
                                       size_t joints,
                                       const float *locals,
                                       float *models,
                                       size_t count);

/**
 * As dq8_local_to_model, joint by joint in the `order` that dq8_plan_make found for
 * the same parents, with the eight numbers of a motion in one register: the fastest
 * way for one instance. Several are computed as by dq8_local_to_model: `count` motions
 * in all, `joints` times instances. `models` may be `locals`.
 *
 * DQ8_STATUS_NO_PLAN if a pair of `order` is not a joint and its parent, or a root
 * stands behind other joints. An order whose pairs have changed places is not noticed.
 */
dq8_status dq8_plan_local_to_model_f64(const int32_t *parents,
                                       const uint32_t *order,
                                       size_t joints,
                                       const double *locals,
                                       double *models,
                                       size_t count);

/**
 * Fills in the options that serve most: 1e-5 rad, 1e-5 lengths, 100 iterations,
 * restarts.
 */
dq8_status dq8_mechanism_reach_options_f32(struct dq8_reach_options_f32 *options);

/**
 * How many numbers `scratch` of dq8_mechanism_reach must have for so many goals, for
 * one mechanism always the same. DQ8_STATUS_TOO_LARGE for more than 1024 goals.
 */
dq8_status dq8_mechanism_reach_scratch_f32(const struct dq8_mechanism_f32 *mechanism,
                                           size_t goal_count,
                                           size_t *scratch_count);

/**
 * Inverse kinematics of one configuration: moves `values` until the link of each goal
 * is at its target, a motion for each goal; within the limits of the joints. From a
 * start nearby it converges in a few steps.
 *
 * `posture`, as many values, or null: a configuration that is preferred where the
 * goals leave freedom. `options` null: those of dq8_mechanism_reach_options. `scratch`
 * may hold anything. DQ8_STATUS_OK says that there is a report, not that the targets
 * are reached: see `outcome`.
 *
 * DQ8_STATUS_NO_LINK, _UNMOVED, _WEIGHT (one is negative or not finite, or a goal has
 * none, or there is no goal), _LIMITS, _NOT_FINITE (the posture, or a point) or
 * _UNKNOWN_VALUE (`restarts`); then `scratch` may have been written, the values and
 * the report not.
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
 * Fills in the options that serve most: 1e-5 rad, 1e-5 lengths, 100 iterations,
 * restarts.
 */
dq8_status dq8_mechanism_reach_options_f64(struct dq8_reach_options_f64 *options);

/**
 * How many numbers `scratch` of dq8_mechanism_reach must have for so many goals, for
 * one mechanism always the same. DQ8_STATUS_TOO_LARGE for more than 1024 goals.
 */
dq8_status dq8_mechanism_reach_scratch_f64(const struct dq8_mechanism_f64 *mechanism,
                                           size_t goal_count,
                                           size_t *scratch_count);

/**
 * Inverse kinematics of one configuration: moves `values` until the link of each goal
 * is at its target, a motion for each goal; within the limits of the joints. From a
 * start nearby it converges in a few steps.
 *
 * `posture`, as many values, or null: a configuration that is preferred where the
 * goals leave freedom. `options` null: those of dq8_mechanism_reach_options. `scratch`
 * may hold anything. DQ8_STATUS_OK says that there is a report, not that the targets
 * are reached: see `outcome`.
 *
 * DQ8_STATUS_NO_LINK, _UNMOVED, _WEIGHT (one is negative or not finite, or a goal has
 * none, or there is no goal), _LIMITS, _NOT_FINITE (the posture, or a point) or
 * _UNKNOWN_VALUE (`restarts`); then `scratch` may have been written, the values and
 * the report not.
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
 * From `a` to `b` by the shorter way, `t` of it: linear and normalized.
 * DQ8_STATUS_NOT_NORMALIZABLE if the sum is no motion.
 */
dq8_status dq8_motion_nlerp_f32(const float *a, const float *b, float t, float *out);

/**
 * From unit `a` to unit `b` by the shorter way, `t` of it, along one screw at constant
 * speed.
 */
dq8_status dq8_motion_sclerp_f32(const float *a, const float *b, float t, float *out);

/**
 * The blend of `count` unit motions by `weights`, which need not sum to 1: their sum,
 * each turned toward the first, normalized (dual quaternion linear blending).
 *
 * DQ8_STATUS_NO_INFLUENCES if `count` is 0, DQ8_STATUS_NOT_NORMALIZABLE if the sum is
 * no motion.
 */
dq8_status dq8_motion_blend_f32(const float *motions,
                                const float *weights,
                                size_t count,
                                float *out);

/**
 * The logarithm of a unit motion, six numbers: half the angle times the axis, and its
 * moment.
 */
dq8_status dq8_motion_log_f32(const float *motion, float *log);

/**
 * The motion of a logarithm of six numbers.
 */
dq8_status dq8_motion_exp_f32(const float *log, float *out);

/**
 * `t` of a unit motion: the same screw axis, t times the angle and the slide.
 */
dq8_status dq8_motion_pow_f32(const float *motion, float t, float *out);

/**
 * The screw of a unit motion, eight numbers: direction of the axis, moment of the
 * axis, angle in 0 to pi, slide along the axis. A translation has angle 0.
 */
dq8_status dq8_motion_to_screw_f32(const float *motion, float *screw);

/**
 * The motion of a screw, eight numbers: direction of length 1, moment at right angles
 * to it, angle, slide.
 */
dq8_status dq8_motion_from_screw_f32(const float *numbers, float *out);

/**
 * From `a` to `b` by the shorter way, `t` of it: linear and normalized.
 * DQ8_STATUS_NOT_NORMALIZABLE if the sum is no motion.
 */
dq8_status dq8_motion_nlerp_f64(const double *a, const double *b, double t, double *out);

/**
 * From unit `a` to unit `b` by the shorter way, `t` of it, along one screw at constant
 * speed.
 */
dq8_status dq8_motion_sclerp_f64(const double *a, const double *b, double t, double *out);

/**
 * The blend of `count` unit motions by `weights`, which need not sum to 1: their sum,
 * each turned toward the first, normalized (dual quaternion linear blending).
 *
 * DQ8_STATUS_NO_INFLUENCES if `count` is 0, DQ8_STATUS_NOT_NORMALIZABLE if the sum is
 * no motion.
 */
dq8_status dq8_motion_blend_f64(const double *motions,
                                const double *weights,
                                size_t count,
                                double *out);

/**
 * The logarithm of a unit motion, six numbers: half the angle times the axis, and its
 * moment.
 */
dq8_status dq8_motion_log_f64(const double *motion, double *log);

/**
 * The motion of a logarithm of six numbers.
 */
dq8_status dq8_motion_exp_f64(const double *log, double *out);

/**
 * `t` of a unit motion: the same screw axis, t times the angle and the slide.
 */
dq8_status dq8_motion_pow_f64(const double *motion, double t, double *out);

/**
 * The screw of a unit motion, eight numbers: direction of the axis, moment of the
 * axis, angle in 0 to pi, slide along the axis. A translation has angle 0.
 */
dq8_status dq8_motion_to_screw_f64(const double *motion, double *screw);

/**
 * The motion of a screw, eight numbers: direction of length 1, moment at right angles
 * to it, angle, slide.
 */
dq8_status dq8_motion_from_screw_f64(const double *numbers, double *out);

/**
 * Checks which joints move each vertex and how much, once; the functions that pose the
 * mesh then only compute. `joint_indices` and `weights` hold `influences` numbers of
 * the first vertex, then those of the next; fill unused influences with any joint and
 * weight 0. The skin keeps using both: they must stay where they are, as they are;
 * what its functions do is undefined if they change.
 *
 * DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM; `bad_vertex`, which may be
 * null, is set to that vertex. DQ8_STATUS_NO_INFLUENCES if `influences` is 0. The skin
 * has then not been written.
 */
dq8_status dq8_skin_make_f32(size_t joint_count,
                             size_t influences,
                             const uint16_t *joint_indices,
                             const float *weights,
                             size_t vertices,
                             struct dq8_skin_f32 *skin,
                             size_t *bad_vertex);

/**
 * As dq8_skin_make, of joints and weights that lie between other fields, such as in a
 * vertex buffer: `joint_indices` and `weights` hold `stride` elements per vertex, of
 * which `influences` from `first` on are the field; they may be the same memory. A
 * stride or an offset in bytes, divided by the size of an element, is one in elements.
 * DQ8_STATUS_FIELD if the field lies beyond its vertex.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * Poses a mesh by linear blends: each vertex by the weighted sum of `matrices`, the
 * palette, twelve numbers per joint, row after row. Weights must sum to 1.
 *
 * `positions`, and `normals` and `tangents` if not null, hold three numbers per
 * vertex; what becomes of them goes to `posed_positions`, `posed_normals` and
 * `posed_tangents`, which must overlap nothing. `joint_count` and `vertices` are those
 * of the skin, or it is DQ8_STATUS_LENGTH.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * As dq8_skin_linear by dual quaternion blends: each vertex by the weighted sum of
 * `motions`, the palette, normalized, each with the sign that turns it toward that of
 * the greatest weight. Twists keep their volume.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * As dq8_skin_dual where joints scale or shear: before the motions come the weighted
 * sums of `stretches`, matrices of twelve numbers per joint. dq8_skin_split makes
 * both.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * As dq8_skin_linear and dq8_skin_dual, mixed by a number per vertex against the bulge
 * of the second at bent joints: (1 − s) times the first and s times the second, s
 * from `shares`. DQ8_STATUS_SHARE if one is not in [0, 1].
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
 * Checks which joints move each vertex and how much, once; the functions that pose the
 * mesh then only compute. `joint_indices` and `weights` hold `influences` numbers of
 * the first vertex, then those of the next; fill unused influences with any joint and
 * weight 0. The skin keeps using both: they must stay where they are, as they are;
 * what its functions do is undefined if they change.
 *
 * DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM; `bad_vertex`, which may be
 * null, is set to that vertex. DQ8_STATUS_NO_INFLUENCES if `influences` is 0. The skin
 * has then not been written.
 */
dq8_status dq8_skin_make_f64(size_t joint_count,
                             size_t influences,
                             const uint16_t *joint_indices,
                             const double *weights,
                             size_t vertices,
                             struct dq8_skin_f64 *skin,
                             size_t *bad_vertex);

/**
 * As dq8_skin_make, of joints and weights that lie between other fields, such as in a
 * vertex buffer: `joint_indices` and `weights` hold `stride` elements per vertex, of
 * which `influences` from `first` on are the field; they may be the same memory. A
 * stride or an offset in bytes, divided by the size of an element, is one in elements.
 * DQ8_STATUS_FIELD if the field lies beyond its vertex.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * Poses a mesh by linear blends: each vertex by the weighted sum of `matrices`, the
 * palette, twelve numbers per joint, row after row. Weights must sum to 1.
 *
 * `positions`, and `normals` and `tangents` if not null, hold three numbers per
 * vertex; what becomes of them goes to `posed_positions`, `posed_normals` and
 * `posed_tangents`, which must overlap nothing. `joint_count` and `vertices` are those
 * of the skin, or it is DQ8_STATUS_LENGTH.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * As dq8_skin_linear by dual quaternion blends: each vertex by the weighted sum of
 * `motions`, the palette, normalized, each with the sign that turns it toward that of
 * the greatest weight. Twists keep their volume.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * As dq8_skin_dual where joints scale or shear: before the motions come the weighted
 * sums of `stretches`, matrices of twelve numbers per joint. dq8_skin_split makes
 * both.
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
 * As without _interleaved, of vertices that are records of several fields, such as the
 * vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
 * two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
 * buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
 * field lies beyond its vertex or in another one. Everything else in `posed` is left
 * alone.
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
 * As dq8_skin_linear and dq8_skin_dual, mixed by a number per vertex against the bulge
 * of the second at bent joints: (1 − s) times the first and s times the second, s
 * from `shares`. DQ8_STATUS_SHARE if one is not in [0, 1].
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
 * `out[i] = a[i] * b[i]`: b acts first. `out` may be `a`.
 */
dq8_status dq8_mul_f32(const float *a, const float *b, float *out, size_t count);

/**
 * dq8_mul_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_mul_f32(size_t lanes,
                              const float *a,
                              const float *b,
                              float *out,
                              size_t count);

/**
 * The unit motions beside `motions`, NaN where there is none; dq8_motion_normalize
 * tells so. `out` may be `motions`.
 */
dq8_status dq8_normalize_f32(const float *motions, float *out, size_t count);

/**
 * dq8_normalize_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_normalize_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * The inverses of `motions`, unit or not; NaN or infinite where there is none;
 * dq8_motion_inverse tells so. `out` may be `motions`.
 */
dq8_status dq8_inverse_f32(const float *motions, float *out, size_t count);

/**
 * dq8_inverse_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_inverse_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * The inverses of unit `motions`, which cost nothing but signs. `out` may be
 * `motions`.
 */
dq8_status dq8_conjugate_f32(const float *motions, float *out, size_t count);

/**
 * dq8_conjugate_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_conjugate_f32(size_t lanes, const float *motions, float *out, size_t count);

/**
 * From `a[i]` to `b[i]` by the shorter way, `t` of it: linear and normalized.
 */
dq8_status dq8_nlerp_f32(const float *a, const float *b, float t, float *out, size_t count);

/**
 * dq8_nlerp_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_nlerp_f32(size_t lanes,
                                const float *a,
                                const float *b,
                                float t,
                                float *out,
                                size_t count);

/**
 * As dq8_nlerp with a number `t[i]` for each.
 */
dq8_status dq8_nlerp_each_f32(const float *a,
                              const float *b,
                              const float *t,
                              float *out,
                              size_t count);

/**
 * dq8_nlerp_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_nlerp_each_f32(size_t lanes,
                                     const float *a,
                                     const float *b,
                                     const float *t,
                                     float *out,
                                     size_t count);

/**
 * From unit `a[i]` to unit `b[i]` by the shorter way, `t` of it, along one screw at
 * constant speed.
 */
dq8_status dq8_sclerp_f32(const float *a, const float *b, float t, float *out, size_t count);

/**
 * dq8_sclerp_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_sclerp_f32(size_t lanes,
                                 const float *a,
                                 const float *b,
                                 float t,
                                 float *out,
                                 size_t count);

/**
 * As dq8_sclerp with a number `t[i]` for each.
 */
dq8_status dq8_sclerp_each_f32(const float *a,
                               const float *b,
                               const float *t,
                               float *out,
                               size_t count);

/**
 * dq8_sclerp_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_sclerp_each_f32(size_t lanes,
                                      const float *a,
                                      const float *b,
                                      const float *t,
                                      float *out,
                                      size_t count);

/**
 * `points`, three numbers each, moved by the one unit `motion`. `out` may be `points`.
 */
dq8_status dq8_points_f32(const float *motion, const float *points, float *out, size_t count);

/**
 * dq8_points_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_points_f32(size_t lanes,
                                 const float *motion,
                                 const float *points,
                                 float *out,
                                 size_t count);

/**
 * `vectors`, three numbers each, turned by the one unit `motion`: directions do not
 * translate. `out` may be `vectors`.
 */
dq8_status dq8_vectors_f32(const float *motion, const float *vectors, float *out, size_t count);

/**
 * dq8_vectors_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_vectors_f32(size_t lanes,
                                  const float *motion,
                                  const float *vectors,
                                  float *out,
                                  size_t count);

/**
 * `points[i]`, three numbers each, moved by the unit `motions[i]`.
 */
dq8_status dq8_points_each_f32(const float *motions, const float *points, float *out, size_t count);

/**
 * dq8_points_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_points_each_f32(size_t lanes,
                                      const float *motions,
                                      const float *points,
                                      float *out,
                                      size_t count);

/**
 * `vectors[i]`, three numbers each, turned by the unit `motions[i]`.
 */
dq8_status dq8_vectors_each_f32(const float *motions,
                                const float *vectors,
                                float *out,
                                size_t count);

/**
 * dq8_vectors_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_vectors_each_f32(size_t lanes,
                                       const float *motions,
                                       const float *vectors,
                                       float *out,
                                       size_t count);

/**
 * The matrices `[R | t]` of unit `motions`, twelve numbers each; `order` is one of
 * enum dq8_matrix_order.
 */
dq8_status dq8_matrices_3x4_f32(const float *motions, int32_t order, float *out, size_t count);

/**
 * dq8_matrices_3x4_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_matrices_3x4_f32(size_t lanes,
                                       const float *motions,
                                       int32_t order,
                                       float *out,
                                       size_t count);

/**
 * The matrices of unit `motions` with the row 0 0 0 1, sixteen numbers each; `order`
 * is one of enum dq8_matrix_order.
 */
dq8_status dq8_matrices_4x4_f32(const float *motions, int32_t order, float *out, size_t count);

/**
 * dq8_matrices_4x4_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_matrices_4x4_f32(size_t lanes,
                                       const float *motions,
                                       int32_t order,
                                       float *out,
                                       size_t count);

/**
 * `out[i] = a[i] * b[i]`: b acts first. `out` may be `a`.
 */
dq8_status dq8_mul_f64(const double *a, const double *b, double *out, size_t count);

/**
 * dq8_mul_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_mul_f64(size_t lanes,
                              const double *a,
                              const double *b,
                              double *out,
                              size_t count);

/**
 * The unit motions beside `motions`, NaN where there is none; dq8_motion_normalize
 * tells so. `out` may be `motions`.
 */
dq8_status dq8_normalize_f64(const double *motions, double *out, size_t count);

/**
 * dq8_normalize_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_normalize_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * The inverses of `motions`, unit or not; NaN or infinite where there is none;
 * dq8_motion_inverse tells so. `out` may be `motions`.
 */
dq8_status dq8_inverse_f64(const double *motions, double *out, size_t count);

/**
 * dq8_inverse_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_inverse_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * The inverses of unit `motions`, which cost nothing but signs. `out` may be
 * `motions`.
 */
dq8_status dq8_conjugate_f64(const double *motions, double *out, size_t count);

/**
 * dq8_conjugate_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_conjugate_f64(size_t lanes, const double *motions, double *out, size_t count);

/**
 * From `a[i]` to `b[i]` by the shorter way, `t` of it: linear and normalized.
 */
dq8_status dq8_nlerp_f64(const double *a, const double *b, double t, double *out, size_t count);

/**
 * dq8_nlerp_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_nlerp_f64(size_t lanes,
                                const double *a,
                                const double *b,
                                double t,
                                double *out,
                                size_t count);

/**
 * As dq8_nlerp with a number `t[i]` for each.
 */
dq8_status dq8_nlerp_each_f64(const double *a,
                              const double *b,
                              const double *t,
                              double *out,
                              size_t count);

/**
 * dq8_nlerp_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_nlerp_each_f64(size_t lanes,
                                     const double *a,
                                     const double *b,
                                     const double *t,
                                     double *out,
                                     size_t count);

/**
 * From unit `a[i]` to unit `b[i]` by the shorter way, `t` of it, along one screw at
 * constant speed.
 */
dq8_status dq8_sclerp_f64(const double *a, const double *b, double t, double *out, size_t count);

/**
 * dq8_sclerp_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_sclerp_f64(size_t lanes,
                                 const double *a,
                                 const double *b,
                                 double t,
                                 double *out,
                                 size_t count);

/**
 * As dq8_sclerp with a number `t[i]` for each.
 */
dq8_status dq8_sclerp_each_f64(const double *a,
                               const double *b,
                               const double *t,
                               double *out,
                               size_t count);

/**
 * dq8_sclerp_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_sclerp_each_f64(size_t lanes,
                                      const double *a,
                                      const double *b,
                                      const double *t,
                                      double *out,
                                      size_t count);

/**
 * `points`, three numbers each, moved by the one unit `motion`. `out` may be `points`.
 */
dq8_status dq8_points_f64(const double *motion, const double *points, double *out, size_t count);

/**
 * dq8_points_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_points_f64(size_t lanes,
                                 const double *motion,
                                 const double *points,
                                 double *out,
                                 size_t count);

/**
 * `vectors`, three numbers each, turned by the one unit `motion`: directions do not
 * translate. `out` may be `vectors`.
 */
dq8_status dq8_vectors_f64(const double *motion, const double *vectors, double *out, size_t count);

/**
 * dq8_vectors_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_vectors_f64(size_t lanes,
                                  const double *motion,
                                  const double *vectors,
                                  double *out,
                                  size_t count);

/**
 * `points[i]`, three numbers each, moved by the unit `motions[i]`.
 */
dq8_status dq8_points_each_f64(const double *motions,
                               const double *points,
                               double *out,
                               size_t count);

/**
 * dq8_points_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_points_each_f64(size_t lanes,
                                      const double *motions,
                                      const double *points,
                                      double *out,
                                      size_t count);

/**
 * `vectors[i]`, three numbers each, turned by the unit `motions[i]`.
 */
dq8_status dq8_vectors_each_f64(const double *motions,
                                const double *vectors,
                                double *out,
                                size_t count);

/**
 * dq8_vectors_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_vectors_each_f64(size_t lanes,
                                       const double *motions,
                                       const double *vectors,
                                       double *out,
                                       size_t count);

/**
 * The matrices `[R | t]` of unit `motions`, twelve numbers each; `order` is one of
 * enum dq8_matrix_order.
 */
dq8_status dq8_matrices_3x4_f64(const double *motions, int32_t order, double *out, size_t count);

/**
 * dq8_matrices_3x4_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_matrices_3x4_f64(size_t lanes,
                                       const double *motions,
                                       int32_t order,
                                       double *out,
                                       size_t count);

/**
 * The matrices of unit `motions` with the row 0 0 0 1, sixteen numbers each; `order`
 * is one of enum dq8_matrix_order.
 */
dq8_status dq8_matrices_4x4_f64(const double *motions, int32_t order, double *out, size_t count);

/**
 * dq8_matrices_4x4_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_matrices_4x4_f64(size_t lanes,
                                       const double *motions,
                                       int32_t order,
                                       double *out,
                                       size_t count);

/**
 * What a status means, in English: text that lives as long as the program. A number that is no
 * status has a text too, which says so.
 */
const char *dq8_status_text(int32_t status);

/**
 * How many numbers `scratch` of dq8_reach must have for so many goals, whatever the
 * number of targets; for one mechanism always the same. DQ8_STATUS_TOO_LARGE for more
 * than 1024 goals.
 */
dq8_status dq8_reach_scratch_f32(const struct dq8_mechanism_f32 *mechanism,
                                 size_t goal_count,
                                 size_t *scratch_count);

/**
 * dq8_mechanism_reach for `count` configurations, as many at a time as there are
 * lanes: `targets` are `[configuration][goal]`, `values`, `value_count` in all,
 * `[configuration][value]`, and there is a report for each. Goals, posture and options
 * are the same for all.
 *
 * The result of one does not depend on the others: threads may each have a part of the
 * configurations, with scratch of their own, as many numbers as dq8_reach_scratch
 * says. Errors are those of dq8_mechanism_reach.
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
 * How many numbers `scratch` of dq8_reach must have for so many goals, whatever the
 * number of targets; for one mechanism always the same. DQ8_STATUS_TOO_LARGE for more
 * than 1024 goals.
 */
dq8_status dq8_reach_scratch_f64(const struct dq8_mechanism_f64 *mechanism,
                                 size_t goal_count,
                                 size_t *scratch_count);

/**
 * dq8_mechanism_reach for `count` configurations, as many at a time as there are
 * lanes: `targets` are `[configuration][goal]`, `values`, `value_count` in all,
 * `[configuration][value]`, and there is a report for each. Goals, posture and options
 * are the same for all.
 *
 * The result of one does not depend on the others: threads may each have a part of the
 * configurations, with scratch of their own, as many numbers as dq8_reach_scratch
 * says. Errors are those of dq8_mechanism_reach.
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
 * A trajectory, the unit `poses` at the rising `times`, both `pose_count`, sampled at
 * the times `at`, `count` of them as of `out`: along one screw from each pose to the
 * next, by the shorter way. Before the first pose it is that one, and behind the last
 * one that.
 *
 * DQ8_STATUS_TIMES if a time is not later than the one before or not finite,
 * DQ8_STATUS_NOT_FINITE if one to sample at is NaN; `bad_time`, which may be null, is
 * set to it. DQ8_STATUS_LENGTH if there is no pose.
 */
dq8_status dq8_resample_f32(const float *times,
                            const float *poses,
                            size_t pose_count,
                            const float *at,
                            float *out,
                            size_t count,
                            size_t *bad_time);

/**
 * The unit poses of a trajectory at the `times`, `count` of them as of `out` and of
 * `twists`, which may be null: the velocities there for one second, in the frame of
 * the body, angular first. The trajectory has `pose_count` unit `poses` at rising
 * `stamps` in seconds, and goes along one screw from each to the next, by the shorter
 * way. `options` may be null: times are seconds, results are in the world, and the
 * body stands before the first stamp and after the last one.
 *
 * DQ8_STATUS_TIMES if a stamp is not later than the one before or not finite,
 * DQ8_STATUS_OUTSIDE if a time is refused or the frame has none; `bad_time`, which may
 * be null, is set to the stamp or time. DQ8_STATUS_LENGTH if there is no pose, or one
 * where the body is to go on. NaN makes NaN of its pose.
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
 * Points, x y z, that the body of a trajectory measured, each at its own time: moved
 * into one frame, by the pose at that time. `moved` may be `points`. A scan is thereby
 * as if it had been measured at one moment. Trajectory, options and errors are those
 * of dq8_trajectory_sample.
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
 * The inverse of dq8_trajectory_deskew: points of one frame as the body would have
 * measured them, each at its own time.
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
 * A cubic spline at the `times`, `count` of them as of `out` and, each unless it is
 * null, of `twists` and `accelerations`: velocities for one second in the frame of the
 * body, angular first, and how fast they change. The spline has `control_count` unit
 * control poses, four or more: number k at the time start + every * (k - 1), in
 * seconds. `basis` is 0 for a B-spline, which goes near them, 1 for that of Catmull
 * and Rom, which goes through all but the first and the last. Options are those of
 * dq8_trajectory_sample.
 *
 * DQ8_STATUS_TIMES if the interval is not positive, DQ8_STATUS_NOT_FINITE if a control
 * pose is not finite, DQ8_STATUS_OUTSIDE if a time is refused; `bad_index`, which may
 * be null, is set to the control pose or time. DQ8_STATUS_LENGTH if there are fewer
 * than four.
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
 * A trajectory, the unit `poses` at the rising `times`, both `pose_count`, sampled at
 * the times `at`, `count` of them as of `out`: along one screw from each pose to the
 * next, by the shorter way. Before the first pose it is that one, and behind the last
 * one that.
 *
 * DQ8_STATUS_TIMES if a time is not later than the one before or not finite,
 * DQ8_STATUS_NOT_FINITE if one to sample at is NaN; `bad_time`, which may be null, is
 * set to it. DQ8_STATUS_LENGTH if there is no pose.
 */
dq8_status dq8_resample_f64(const double *times,
                            const double *poses,
                            size_t pose_count,
                            const double *at,
                            double *out,
                            size_t count,
                            size_t *bad_time);

/**
 * The unit poses of a trajectory at the `times`, `count` of them as of `out` and of
 * `twists`, which may be null: the velocities there for one second, in the frame of
 * the body, angular first. The trajectory has `pose_count` unit `poses` at rising
 * `stamps` in seconds, and goes along one screw from each to the next, by the shorter
 * way. `options` may be null: times are seconds, results are in the world, and the
 * body stands before the first stamp and after the last one.
 *
 * DQ8_STATUS_TIMES if a stamp is not later than the one before or not finite,
 * DQ8_STATUS_OUTSIDE if a time is refused or the frame has none; `bad_time`, which may
 * be null, is set to the stamp or time. DQ8_STATUS_LENGTH if there is no pose, or one
 * where the body is to go on. NaN makes NaN of its pose.
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
 * Points, x y z, that the body of a trajectory measured, each at its own time: moved
 * into one frame, by the pose at that time. `moved` may be `points`. A scan is thereby
 * as if it had been measured at one moment. Trajectory, options and errors are those
 * of dq8_trajectory_sample.
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
 * The inverse of dq8_trajectory_deskew: points of one frame as the body would have
 * measured them, each at its own time.
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
 * A cubic spline at the `times`, `count` of them as of `out` and, each unless it is
 * null, of `twists` and `accelerations`: velocities for one second in the frame of the
 * body, angular first, and how fast they change. The spline has `control_count` unit
 * control poses, four or more: number k at the time start + every * (k - 1), in
 * seconds. `basis` is 0 for a B-spline, which goes near them, 1 for that of Catmull
 * and Rom, which goes through all but the first and the last. Options are those of
 * dq8_trajectory_sample.
 *
 * DQ8_STATUS_TIMES if the interval is not positive, DQ8_STATUS_NOT_FINITE if a control
 * pose is not finite, DQ8_STATUS_OUTSIDE if a time is refused; `bad_index`, which may
 * be null, is set to the control pose or time. DQ8_STATUS_LENGTH if there are fewer
 * than four.
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

/**
 * `twists[i]`, six numbers, angular part first, by the adjoint of the unit
 * `motions[i]`: a body twist becomes the spatial one.
 */
dq8_status dq8_twists_each_f32(const float *motions, const float *twists, float *out, size_t count);

/**
 * dq8_twists_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_twists_each_f32(size_t lanes,
                                      const float *motions,
                                      const float *twists,
                                      float *out,
                                      size_t count);

/**
 * Where the unit `motions[i]` are after `dt` seconds of the body twists `twists[i]`,
 * six numbers each, angular part first.
 */
dq8_status dq8_integrate_body_f32(const float *motions,
                                  const float *twists,
                                  float dt,
                                  float *out,
                                  size_t count);

/**
 * dq8_integrate_body_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_integrate_body_f32(size_t lanes,
                                         const float *motions,
                                         const float *twists,
                                         float dt,
                                         float *out,
                                         size_t count);

/**
 * The logarithms of unit `motions`, six numbers each: half the angle times the axis,
 * and its moment. Twice that is the twist that leads there in one second.
 */
dq8_status dq8_log_f32(const float *motions, float *logs, size_t count);

/**
 * dq8_log_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_log_f32(size_t lanes, const float *motions, float *logs, size_t count);

/**
 * The motions of `logs`, six numbers each.
 */
dq8_status dq8_exp_f32(const float *logs, float *out, size_t count);

/**
 * dq8_exp_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_exp_f32(size_t lanes, const float *logs, float *out, size_t count);

/**
 * The unit `motions[i]` to the power `t[i]`: the same screw axis, t times the angle
 * and the slide.
 */
dq8_status dq8_pow_each_f32(const float *motions, const float *t, float *out, size_t count);

/**
 * dq8_pow_each_f32 on blocks of 8 or 16 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_pow_each_f32(size_t lanes,
                                   const float *motions,
                                   const float *t,
                                   float *out,
                                   size_t count);

/**
 * `twists[i]`, six numbers, angular part first, by the adjoint of the unit
 * `motions[i]`: a body twist becomes the spatial one.
 */
dq8_status dq8_twists_each_f64(const double *motions,
                               const double *twists,
                               double *out,
                               size_t count);

/**
 * dq8_twists_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_twists_each_f64(size_t lanes,
                                      const double *motions,
                                      const double *twists,
                                      double *out,
                                      size_t count);

/**
 * Where the unit `motions[i]` are after `dt` seconds of the body twists `twists[i]`,
 * six numbers each, angular part first.
 */
dq8_status dq8_integrate_body_f64(const double *motions,
                                  const double *twists,
                                  double dt,
                                  double *out,
                                  size_t count);

/**
 * dq8_integrate_body_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_integrate_body_f64(size_t lanes,
                                         const double *motions,
                                         const double *twists,
                                         double dt,
                                         double *out,
                                         size_t count);

/**
 * The logarithms of unit `motions`, six numbers each: half the angle times the axis,
 * and its moment. Twice that is the twist that leads there in one second.
 */
dq8_status dq8_log_f64(const double *motions, double *logs, size_t count);

/**
 * dq8_log_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_log_f64(size_t lanes, const double *motions, double *logs, size_t count);

/**
 * The motions of `logs`, six numbers each.
 */
dq8_status dq8_exp_f64(const double *logs, double *out, size_t count);

/**
 * dq8_exp_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_exp_f64(size_t lanes, const double *logs, double *out, size_t count);

/**
 * The unit `motions[i]` to the power `t[i]`: the same screw axis, t times the angle
 * and the slide.
 */
dq8_status dq8_pow_each_f64(const double *motions, const double *t, double *out, size_t count);

/**
 * dq8_pow_each_f64 on blocks of 4 or 8 `lanes`; `count` is a number of blocks.
 */
dq8_status dq8_blocks_pow_each_f64(size_t lanes,
                                   const double *motions,
                                   const double *t,
                                   double *out,
                                   size_t count);

/* A joint of this kind, and nothing that it mimics or that limits it. */
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
 * A joint that does not move. `placement` may be null: none.
 */
static inline dq8_joint_f32 dq8_joint_fixed_f32(int32_t parent, const float *placement)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_FIXED, parent, placement, 0);
  return joint;
}

/**
 * A joint that turns about `axis`. `placement` may be null: none.
 */
static inline dq8_joint_f32 dq8_joint_revolute_f32(int32_t parent, const float *placement, const float *axis)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_REVOLUTE, parent, placement, axis);
  return joint;
}

/**
 * A joint that slides along `axis`. `placement` may be null: none.
 */
static inline dq8_joint_f32 dq8_joint_prismatic_f32(int32_t parent, const float *placement, const float *axis)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_PRISMATIC, parent, placement, axis);
  return joint;
}

/**
 * A joint that turns about `axis` and slides along it, `pitch` for each radian. `placement` may be null: none.
 */
static inline dq8_joint_f32 dq8_joint_screw_f32(int32_t parent, const float *placement, const float *axis, float pitch)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_SCREW, parent, placement, axis);
  joint.pitch = pitch;
  return joint;
}

/**
 * A joint that slides in the plane across `axis`, and turns about it. `placement` may be null: none.
 */
static inline dq8_joint_f32 dq8_joint_planar_f32(int32_t parent, const float *placement, const float *axis)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_PLANAR, parent, placement, axis);
  return joint;
}

/**
 * A joint that moves freely. `placement` may be null: none.
 */
static inline dq8_joint_f32 dq8_joint_floating_f32(int32_t parent, const float *placement)
{
  dq8_joint_f32 joint = dq8_joint_of_kind_f32(DQ8_JOINT_KIND_FLOATING, parent, placement, 0);
  return joint;
}

/* A joint of this kind, and nothing that it mimics or that limits it. */
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
 * A joint that does not move. `placement` may be null: none.
 */
static inline dq8_joint_f64 dq8_joint_fixed_f64(int32_t parent, const double *placement)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_FIXED, parent, placement, 0);
  return joint;
}

/**
 * A joint that turns about `axis`. `placement` may be null: none.
 */
static inline dq8_joint_f64 dq8_joint_revolute_f64(int32_t parent, const double *placement, const double *axis)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_REVOLUTE, parent, placement, axis);
  return joint;
}

/**
 * A joint that slides along `axis`. `placement` may be null: none.
 */
static inline dq8_joint_f64 dq8_joint_prismatic_f64(int32_t parent, const double *placement, const double *axis)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_PRISMATIC, parent, placement, axis);
  return joint;
}

/**
 * A joint that turns about `axis` and slides along it, `pitch` for each radian. `placement` may be null: none.
 */
static inline dq8_joint_f64 dq8_joint_screw_f64(int32_t parent, const double *placement, const double *axis, double pitch)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_SCREW, parent, placement, axis);
  joint.pitch = pitch;
  return joint;
}

/**
 * A joint that slides in the plane across `axis`, and turns about it. `placement` may be null: none.
 */
static inline dq8_joint_f64 dq8_joint_planar_f64(int32_t parent, const double *placement, const double *axis)
{
  dq8_joint_f64 joint = dq8_joint_of_kind_f64(DQ8_JOINT_KIND_PLANAR, parent, placement, axis);
  return joint;
}

/**
 * A joint that moves freely. `placement` may be null: none.
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
