/*
 * A robot arm through the C functions of dq8: where its hand is, one arm and many at a time, points in
 * the hand, skinning, a crane, and what happens when a call is wrong. C99 and C++11; no heap, so that it runs
 * on a microcontroller too. Prints what it finds, and returns 0 if all of it is as it must be.
 */
#include "dq8.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { JOINTS = 4, ARMS = 11, LANES = 8, SETS = (ARMS + LANES - 1) / LANES };
#define MOTION 8 /* numbers in a motion */

static int failures = 0;

static void check(int holds, const char *what) {
    if (!holds) {
        printf("FAIL: %s\n", what);
        failures++;
    }
}

/* A call that must end with `wanted`. */
static void ends(dq8_status got, dq8_status wanted, const char *what) {
    if (got != wanted) {
        printf("FAIL: %s: %s\n", what, dq8_status_text(got));
        failures++;
    }
}

static void works(dq8_status got, const char *what) { ends(got, DQ8_STATUS_OK, what); }

static int near(float a, float b) { return fabsf(a - b) < 1e-5f; }

static int near_point(const float *a, float x, float y, float z) {
    return near(a[0], x) && near(a[1], y) && near(a[2], z);
}

/* shoulder, elbow, wrist and a camera on the elbow: parents come first, roots have -1. */
static const int32_t parents[JOINTS] = {-1, 0, 1, 1};
static const float lengths[JOINTS] = {0.0f, 1.0f, 1.0f, 0.5f};

/* Local poses of an arm whose joints all turn by `angle` about z. */
static void bend(float angle, float *locals) {
    float rotation[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    int joint;
    rotation[2] = sinf(angle / 2.0f);
    rotation[3] = cosf(angle / 2.0f);
    for (joint = 0; joint < JOINTS; joint++) {
        float offset[3] = {0.0f, 0.0f, 0.0f};
        offset[0] = lengths[joint];
        works(dq8_motion_from_rotation_translation_f32(rotation, offset, locals + joint * MOTION),
              "from rotation and translation");
    }
}

/* Blocks begin at multiples of 64 bytes: the first such number of a buffer with 15 to spare. */
static float *first_block(float *buffer) {
    return (float *)(((uintptr_t)buffer + 63) / 64 * 64);
}

static void one_arm(void) {
    float locals[JOINTS * MOTION], models[JOINTS * MOTION], back[JOINTS * MOTION];
    float root[MOTION], origin[3] = {0.0f, 0.0f, 0.0f}, up[3] = {0.0f, 0.0f, 2.0f}, hand[3];
    float unturned[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    const float quarter = 1.57079633f;

    bend(quarter, locals);
    works(dq8_check_parents(parents, JOINTS, NULL), "parents");
    works(dq8_local_to_model_f32(parents, JOINTS, NULL, locals, models, JOINTS), "local to model");
    works(dq8_motion_point_f32(models + 2 * MOTION, origin, hand), "point");
    printf("hand of one arm: %.3f %.3f %.3f\n", (double)hand[0], (double)hand[1], (double)hand[2]);
    check(near_point(hand, -1.0f, 1.0f, 0.0f), "the hand of an arm bent by quarters");

    /* The same arm on a table, over its own locals. */
    works(dq8_motion_from_rotation_translation_f32(unturned, up, root), "table");
    memcpy(back, locals, sizeof back);
    works(dq8_local_to_model_f32(parents, JOINTS, root, back, back, JOINTS), "in place");
    works(dq8_motion_point_f32(back + 2 * MOTION, origin, hand), "point");
    check(near_point(hand, -1.0f, 1.0f, 2.0f), "the hand above the table");
    works(dq8_model_to_local_f32(parents, JOINTS, root, back, back, JOINTS), "model to local");
    for (int i = 0; i < JOINTS * MOTION; i++) {
        check(near(back[i], locals[i]), "locals from models");
    }
}

static void motions(void) {
    float a[MOTION], b[MOTION], c[MOTION], log[6], screw[8], matrix[12], rotation[4], translation[3];
    float quarter_about_z[4] = {0.0f, 0.0f, 0.70710678f, 0.70710678f}, along_z[3] = {0.0f, 0.0f, 4.0f};
    float weights[2] = {3.0f, 1.0f}, two[2 * MOTION];

    works(dq8_motion_identity_f32(a), "identity");
    works(dq8_motion_from_rotation_translation_f32(quarter_about_z, along_z, b), "screw motion");
    works(dq8_motion_check_unit_f32(b, 1e-6f), "unit");
    works(dq8_motion_to_screw_f32(b, screw), "to screw");
    check(near(screw[6], 1.57079633f) && near(screw[7], 4.0f), "angle and slide");
    works(dq8_motion_from_screw_f32(screw, c), "from screw");
    works(dq8_motion_log_f32(c, log), "log");
    works(dq8_motion_exp_f32(log, c), "exp");
    works(dq8_motion_sclerp_f32(a, c, 0.25f, c), "a quarter of the way");
    works(dq8_motion_pow_f32(c, 4.0f, c), "and four times that");
    works(dq8_motion_inverse_f32(c, c), "back");
    works(dq8_motion_mul_f32(b, c, c), "there and back");
    works(dq8_motion_to_rotation_translation_f32(c, rotation, translation), "parts");
    check(near(rotation[3], 1.0f) && near_point(translation, 0.0f, 0.0f, 0.0f), "identity again");

    works(dq8_motion_to_matrix_3x4_f32(b, matrix), "to matrix");
    works(dq8_motion_from_matrix_3x4_f32(matrix, 1e-5f, c), "from matrix");
    for (int i = 0; i < MOTION; i++) check(near(b[i], c[i]), "the motion of its matrix");

    memcpy(two, a, sizeof a);
    memcpy(two + MOTION, b, sizeof b);
    works(dq8_motion_blend_f32(two, weights, 2, c), "blend");
    works(dq8_motion_to_rotation_translation_f32(c, rotation, translation), "parts");
    check(translation[2] > 0.5f && translation[2] < 2.0f, "three parts of a, one of b");
}

/* Eleven arms, each bent more: lanes are arms. */
static void crowd(void) {
    static float poses[ARMS * JOINTS * MOTION], models[ARMS * JOINTS * MOTION];
    static float buffer[SETS * JOINTS * MOTION * LANES + 15];
    float *blocks = first_block(buffer);
    const size_t count = SETS * JOINTS;

    for (int arm = 0; arm < ARMS; arm++) bend(0.1f * (float)arm, poses + arm * JOINTS * MOTION);
    check(dq8_block_size_f32(LANES, MOTION) == MOTION * LANES, "size of a block");
    works(dq8_pack_f32(LANES, JOINTS, poses, ARMS * JOINTS, blocks, count), "pack");
    works(dq8_blocks_local_to_model_f32(LANES, parents, JOINTS, NULL, blocks, blocks, count),
          "local to model of blocks");
    works(dq8_unpack_f32(LANES, JOINTS, blocks, count, models, ARMS * JOINTS), "unpack");
    for (int arm = 0; arm < ARMS; arm++) {
        const float a = 0.1f * (float)arm, origin[3] = {0.0f, 0.0f, 0.0f};
        float hand[3];
        works(dq8_motion_point_f32(models + (arm * JOINTS + 2) * MOTION, origin, hand), "point");
        check(near_point(hand, cosf(a) + cosf(2.0f * a), sinf(a) + sinf(2.0f * a), 0.0f),
              "the hand of an arm of many");
    }
    printf("%d hands with %s\n", ARMS, dq8_backend_name());
}

static void skin(void) {
    float rest[JOINTS * MOTION], locals[JOINTS * MOTION], models[JOINTS * MOTION];
    float binds[JOINTS * MOTION], palette[JOINTS * 12], points[5 * 3];

    bend(0.0f, rest);
    works(dq8_local_to_model_f32(parents, JOINTS, NULL, rest, models, JOINTS), "rest pose");
    works(dq8_inverse_f32(models, binds, JOINTS), "inverse binds");
    bend(1.57079633f, locals);
    works(dq8_palette_matrices_f32(parents, JOINTS, NULL, locals, binds, models, palette, JOINTS),
          "palette");
    /* The vertex at the tip, (2, 0, 0), is where the hand went. */
    check(near(2.0f * palette[2 * 12] + palette[2 * 12 + 3], -1.0f), "x of the vertex");
    check(near(2.0f * palette[2 * 12 + 4] + palette[2 * 12 + 7], 1.0f), "y of the vertex");

    for (int i = 0; i < 5; i++) {
        points[i * 3] = (float)i;
        points[i * 3 + 1] = points[i * 3 + 2] = 0.0f;
    }
    works(dq8_points_f32(models + 2 * MOTION, points, points, 5), "points in place");
    check(near_point(points + 4 * 3, -1.0f, -3.0f, 0.0f), "the last point");
}

/*
 * A crane as joints: a mast that turns about z, an arm that slides along x, and a hook on it. Made once,
 * in memory of the program; then poses and Jacobian are a call each, from the joints' values.
 */
static void crane(void) {
    static const dq8_joint_f32 joints[3] = {
        {-1, DQ8_JOINT_KIND_REVOLUTE, {0, 0, 0, 1, 0, 0, 0, 0}, {0, 0, 1}, 0, 0, 0, 0, 0, 0, {0, 0}},
        /* At (0, 0, 2). */
        {0, DQ8_JOINT_KIND_PRISMATIC, {0, 0, 0, 1, 0, 0, 1, 0}, {1, 0, 0}, 0, 0, 0, 0, 0, 1, {0, 4}},
        {1, DQ8_JOINT_KIND_FIXED, {0, 0, 0, 1, 0, 0, -0.5f, 0}, {0, 0, 0}, 0, 0, 0, 0, 0, 0, {0, 0}},
    };
    static dq8_step_f32 steps[3];
    dq8_mechanism_f32 mechanism;
    const float values[2] = {1.57079633f, 3.0f}, origin[3] = {0.0f, 0.0f, 0.0f};
    float poses[3 * MOTION], pose[MOTION], columns[2 * 6], hook[3], many[4], crowded[2 * 3 * MOTION];
    dq8_joint_f32 bent[3];
    size_t bad = 99;

    works(dq8_mechanism_make_f32(joints, 3, steps, &mechanism, &bad), "crane");
    check(mechanism.links == 3 && mechanism.values == 2 && mechanism.rates == 2, "its shape");
    works(dq8_mechanism_link_poses_f32(&mechanism, values, 2, poses, 3), "poses of links");
    works(dq8_motion_point_f32(poses + 2 * MOTION, origin, hook), "point");
    check(near_point(hook, 0.0f, 3.0f, 1.0f), "the hook of a crane turned by a quarter");
    works(dq8_mechanism_link_pose_f32(&mechanism, values, 2, 2, pose), "pose of the hook");
    works(dq8_motion_point_f32(pose, origin, hook), "point");
    check(near_point(hook, 0.0f, 3.0f, 1.0f), "the hook alone");

    works(dq8_mechanism_link_jacobian_f32(&mechanism, DQ8_FRAME_WORLD_ALIGNED, values, 2, 2, columns, 2,
                                          NULL), "Jacobian");
    check(near_point(columns, 0.0f, 0.0f, 1.0f), "the mast turns the hook about z");
    check(near_point(columns + 3, -3.0f, 0.0f, 0.0f), "and moves it across");
    check(near_point(columns + 6, 0.0f, 0.0f, 0.0f), "the slide turns nothing");
    check(near_point(columns + 9, 0.0f, 1.0f, 0.0f), "and moves the hook outward");

    /* And back: how far the crane turns and reaches out for a place of the hook; the rotation is free. */
    {
        static float scratch[400];
        const dq8_goal_f32 goal = {2, {0, 0, 0}, {1, 1, 1}, {0, 0, 0}};
        /* The hook at (2, 0, 1). */
        const float target[MOTION] = {0, 0, 0, 1, 1, 0, 0.5f, 0};
        float solved[2] = {1.0f, 1.0f};
        dq8_reach_report_f32 report;
        size_t needed = 0;

        works(dq8_mechanism_reach_scratch_f32(&mechanism, 1, &needed), "scratch");
        check(needed <= 400, "the scratch is enough");
        works(dq8_mechanism_reach_f32(&mechanism, &goal, target, 1, NULL, NULL, solved, 2, scratch, 400,
                                      &report), "reach");
        check(report.outcome == DQ8_OUTCOME_CONVERGED, "the hook is there");
        works(dq8_mechanism_link_pose_f32(&mechanism, solved, 2, 2, pose), "pose of the hook");
        works(dq8_motion_point_f32(pose, origin, hook), "point");
        check(near_point(hook, 2.0f, 0.0f, 1.0f), "and not elsewhere");
    }

    memcpy(many, values, sizeof values);
    many[2] = 0.0f;
    many[3] = 1.0f;
    works(dq8_link_poses_f32(&mechanism, many, 4, crowded, 6), "poses of two configurations");
    works(dq8_motion_point_f32(crowded + 5 * MOTION, origin, hook), "point");
    check(near_point(hook, 1.0f, 0.0f, 1.0f), "the hook of the second crane");

    memcpy(bent, joints, sizeof bent);
    bent[1].axis[0] = 2.0f;
    ends(dq8_mechanism_make_f32(bent, 3, steps, &mechanism, &bad), DQ8_STATUS_AXIS, "axis");
    check(bad == 1, "the joint whose axis is too long");
    memset(&mechanism, 0, sizeof mechanism);
    ends(dq8_mechanism_link_poses_f32(&mechanism, values, 2, poses, 3), DQ8_STATUS_NO_MECHANISM,
         "no crane");
}

/* Each mistake has its number, and nothing is written. */
static void mistakes(void) {
    static float buffer[4 * MOTION * LANES + 15];
    float *blocks = first_block(buffer), locals[JOINTS * MOTION], out[JOINTS * MOTION];
    float zero[MOTION] = {0.0f};
    const int32_t forward[3] = {-1, 2, 1}, outside[2] = {-1, 7};
    size_t bad = 99;

    bend(0.5f, locals);
    memset(out, 0, sizeof out);
    ends(dq8_mul_f32(locals, NULL, out, 1), DQ8_STATUS_NULL_POINTER, "null");
    ends(dq8_mul_f32(locals, (const float *)((const char *)locals + 1), out, 1),
         DQ8_STATUS_MISALIGNED, "misaligned");
    ends(dq8_blocks_normalize_f32(LANES, blocks + 4, blocks + 4, 1), DQ8_STATUS_MISALIGNED,
         "misaligned block");
    ends(dq8_mul_f32(locals, locals + MOTION, locals + 2, 1), DQ8_STATUS_OVERLAP, "overlap");
    ends(dq8_mul_f32(locals, locals, out, (size_t)-1 / 8), DQ8_STATUS_TOO_LARGE, "too large");
    ends(dq8_blocks_normalize_f32(5, blocks, blocks, 1), DQ8_STATUS_LANES, "lanes");
    ends(dq8_local_to_model_f32(parents, JOINTS, NULL, locals, out, JOINTS - 1),
         DQ8_STATUS_LENGTH, "no whole arm");
    ends(dq8_check_parents(forward, 3, &bad), DQ8_STATUS_PARENT_NOT_BEFORE, "forward");
    check(bad == 1, "the joint before its parent");
    ends(dq8_check_parents(outside, 2, &bad), DQ8_STATUS_PARENT_OUT_OF_RANGE, "outside");
    ends(dq8_motion_normalize_f32(zero, out), DQ8_STATUS_NOT_NORMALIZABLE, "zero");
    ends(dq8_motion_blend_f32(NULL, NULL, 0, out), DQ8_STATUS_NO_INFLUENCES, "nothing to blend");
    ends(dq8_backend_limit(77), DQ8_STATUS_UNKNOWN_VALUE, "no backend");
    for (int i = 0; i < JOINTS * MOTION; i++) check(out[i] == 0.0f, "untouched");
    works(dq8_mul_f32(NULL, NULL, NULL, 0), "nothing, from nowhere to nowhere");
}

int main(void) {
    one_arm();
    motions();
    crowd();
    works(dq8_backend_limit(DQ8_BACKEND_PORTABLE), "limit");
    crowd();
    works(dq8_backend_limit(DQ8_BACKEND_ANY), "no limit");
    skin();
    crane();
    mistakes();
    if (failures != 0) {
        printf("%d failures\n", failures);
        return 1;
    }
    printf("PASS\n");
    return 0;
}
