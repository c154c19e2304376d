/*
 * A character with a packed clip, an arm of six hinges and a scan in C99. scene.cpp does the same.
 *
 *     cc -std=c99 scene.c $(pkg-config --cflags --libs dq8) -lm
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "dq8.h"

static void done(dq8_status status, const char *call)
{
  if (status == DQ8_STATUS_OK) return;
  printf("%s: %s\n", call, dq8_status_text(status));
  exit(1);
}
#define DO(call) done(call, #call)

int main(void)
{
  /* Two joints: the first one slides from 0 to 2 in two seconds, the second one is beside it. Its clip, packed, and played. */
  static const int32_t parents[2] = {-1, 0};
  static const float keys[3][2][7] = {
      {{0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 1}}, {{0, 0, 0, 1, 1}, {0, 0, 0, 1, 0, 1}}, {{0, 0, 0, 1, 2}, {0, 0, 0, 1, 0, 1}}};
  const dq8_frames frames = {keys[0][0], 3, 1, 0};
  uint8_t file[1024];
  dq8_clips clips;
  dq8_place place;
  double t, models[2][8], hand[3], z[3] = {0, 0, 1}, y[3] = {0, 1, 0}, x[3] = {1, 0, 0}, origin[3] = {0, 0, 0};
  size_t size, i;
  DO(dq8_clips_pack(&frames, 1, 2, 2e-5f, 1e-5f, file, sizeof file, &size, NULL));
  DO(dq8_clips_make(file, size, &clips, NULL));
  DO(dq8_clips_place_f64(&clips, 0, 0.5, &place, &t));
  DO(dq8_clips_to_model_f64(parents, 2, NULL, &clips, &place, &t, 1, models[0]));
  DO(dq8_motion_point_f64(models[1], origin, hand));

  /* An arm: its pose and its Jacobian, all values that bring it there, and the nearest from other values. */
  const double up[8] = {0, 0, 0, 1, 0, 0, 0.5, 0}, out[8] = {0, 0, 0, 1, 0.5, 0, 0, 0};
  const dq8_joint_f64 joints[6] = {dq8_joint_revolute_f64(-1, NULL, z), dq8_joint_revolute_f64(0, up, y),
                                   dq8_joint_revolute_f64(1, up, y),    dq8_joint_revolute_f64(2, NULL, x),
                                   dq8_joint_revolute_f64(3, out, y),   dq8_joint_revolute_f64(4, NULL, x)};
  const dq8_goal_f64 goal = {5, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}};
  const double values[6] = {0.3, 0.4, 0.9, 0.2, 0.8, 0.1};
  double target[8], columns[6][6], near[6] = {0.2, 0.5, 0.8, 0.2, 0.7, 0}, *scratch;
  dq8_step_f64 steps[6];
  dq8_mechanism_f64 arm;
  dq8_solution_list_f64 found;
  dq8_reach_report_f64 report;
  DO(dq8_mechanism_make_f64(joints, 6, steps, &arm, NULL));
  DO(dq8_mechanism_link_jacobian_f64(&arm, DQ8_FRAME_WORLD_ALIGNED, values, 6, 5, columns[0], 6, target));
  DO(dq8_solutions_scratch_f64(&arm, &size));
  scratch = malloc(size * sizeof *scratch);
  DO(dq8_solutions_f64(&arm, &goal, target, near, scratch, size, &found, 1, NULL));
  free(scratch);
  DO(dq8_mechanism_reach_scratch_f64(&arm, 1, &size));
  scratch = malloc(size * sizeof *scratch);
  DO(dq8_mechanism_reach_f64(&arm, &goal, target, 1, NULL, NULL, near, 6, scratch, size, &report));
  free(scratch);
  for (i = 0; i < found.count; i++) printf("solution %d: %.3f from the start\n", (int)i, found.all[i].distance);

  /* A scan from a body that moves by one metre in a second: all points, as if from where it began. */
  const double stamps[2] = {0, 1}, poses[2][8] = {{0, 0, 0, 1}, {0, 0, 0, 1, 0.5}}, times[2] = {0, 0.5};
  double points[2][3] = {{0, 2, 0}, {0, 2, 0}};
  DO(dq8_trajectory_deskew_f64(stamps, poses[0], 2, NULL, times, points[0], points[0], 2, NULL));

  i = fabs(hand[0] - 0.5) < 1e-4 && found.count > 1 && report.outcome == DQ8_OUTCOME_CONVERGED &&
      fabs(near[3] - found.all[0].values[3]) < 1e-3 && fabs(points[1][0] - 0.5) < 1e-9;
  puts(i ? "PASS" : "FAIL");
  return !i;
}
