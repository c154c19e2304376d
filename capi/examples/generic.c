/*
 * The same arm with float and with double: joints that are filled in by functions, and one name for both numbers (C11).
 *
 *     cc -std=c11 generic.c $(pkg-config --cflags --libs dq8) -lm
 */
#include <math.h>
#include <stdio.h>

#include "dq8_generic.h"

/* Two bones of length 1 that turn about z, and the slide of a tool along x. */
#define ARM(number, suffix)                                                                              \
    static int arm_##suffix(void) {                                                                      \
        const number z[3] = {0, 0, 1}, x[3] = {1, 0, 0}, bone[8] = {0, 0, 0, 1, (number)0.5, 0, 0, 0};   \
        const number values[3] = {(number)0.5, (number)-0.25, (number)0.125}, origin[3] = {0, 0, 0};     \
        const dq8_joint_##suffix joints[4] = {                                                           \
            dq8_joint_revolute_##suffix(-1, NULL, z),                                                    \
            dq8_joint_revolute_##suffix(0, bone, z),                                                     \
            dq8_joint_prismatic_##suffix(1, bone, x),                                                    \
            dq8_joint_fixed_##suffix(2, NULL),                                                           \
        };                                                                                               \
        dq8_step_##suffix steps[4];                                                                      \
        dq8_mechanism_##suffix mechanism;                                                                \
        number pose[8], tool[3];                                                                         \
        if (dq8_mechanism_make(joints, 4, steps, &mechanism, NULL) != DQ8_STATUS_OK                      \
            || dq8_mechanism_link_pose(&mechanism, values, 3, 3, pose) != DQ8_STATUS_OK                  \
            || dq8_motion_point(pose, origin, tool) != DQ8_STATUS_OK) {                                  \
            return 0;                                                                                    \
        }                                                                                                \
        return fabs((double)tool[0] - (cos(0.5) + 1.125 * cos(0.25))) < 1e-6                             \
               && fabs((double)tool[1] - (sin(0.5) + 1.125 * sin(0.25))) < 1e-6 && tool[2] == 0;         \
    }

/* Halfway between two poses. Twists are not asked for: only arrays that are never null choose the number. */
#define SAMPLE(number, suffix)                                                                           \
    static int sample_##suffix(void) {                                                                   \
        const double stamps[2] = {0, 1}, at = 0.5;                                                       \
        const double poses[16] = {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0};                       \
        const dq8_trajectory_options options = {.unit = 1};                                              \
        number pose[8];                                                                                  \
        return dq8_trajectory_sample(stamps, poses, 2, &options, &at, pose, NULL, 1, NULL)               \
                   == DQ8_STATUS_OK                                                                      \
               && fabs((double)pose[4] - 0.5) < 1e-6;                                                    \
    }

ARM(float, f32)
ARM(double, f64)
SAMPLE(float, f32)
SAMPLE(double, f64)

int main(void) {
    const dq8_joint_f64 screw = dq8_joint_screw_f64(-1, NULL, NULL, 0.5);
    const int floats = arm_f32() && sample_f32(), doubles = arm_f64() && sample_f64();
    const int filled = screw.kind == DQ8_JOINT_KIND_SCREW && screw.pitch == 0.5 && screw.placement[3] == 1.0
                       && dq8_joint_planar_f32(2, NULL, NULL).parent == 2
                       && dq8_joint_floating_f32(-1, NULL).kind == DQ8_JOINT_KIND_FLOATING;
    printf("float %s, double %s, joints %s\n", floats ? "right" : "wrong", doubles ? "right" : "wrong",
           filled ? "right" : "wrong");
    puts(floats && doubles && filled ? "PASS" : "FAIL");
    return !(floats && doubles && filled);
}
