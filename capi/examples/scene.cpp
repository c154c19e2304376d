/*
 * A character with a packed clip, an arm of six hinges and a scan in C++17. scene.c does the same.
 *
 *     c++ -std=c++17 scene.cpp $(pkg-config --cflags --libs dq8)
 */
#include <cmath>
#include <cstdio>

#include "dq8.hpp"

using motion = dq8::motion<double>;
using mechanism = dq8::mechanism<double>;

int main() try {
  /* Two joints: the first one slides from 0 to 2 in two seconds, the second one is beside it. Its clip, packed, and played. */
  const dq8::skeleton skeleton({-1, 0});
  std::vector<std::array<float, 7>> keys;
  for (float at : {0.f, 1.f, 2.f}) {
    keys.push_back({0, 0, 0, 1, at, 0, 0});
    keys.push_back({0, 0, 0, 1, 0, 1, 0});
  }
  const auto clips = dq8::clips::pack(2, {{keys, 1}});
  std::vector<motion> models(2), binds(2), palette(2);
  clips.play(skeleton, 0, 0.5, models);
  const auto hand = models[1].point({0, 0, 0});

  /* A mesh of one vertex that follows both joints, from where they rest. */
  const std::vector<motion> rest{motion(), motion::translation_by({0, 1, 0})};
  dq8::inverse(rest, binds);
  dq8::mul(models, binds, palette);
  std::array<double, 3> vertex{0, 0.5, 0}, posed;
  dq8::skin<double>(2, 2, {0, 1}, {0.5, 0.5}).dual(palette, {vertex}, {posed});

  /* An arm: its pose and its Jacobian, all values that bring it there, and the nearest from other values. */
  const motion up = motion::translation_by({0, 0, 1}), out = motion::translation_by({1, 0, 0});
  const mechanism arm(std::vector{
      mechanism::revolute(-1, {}, {0, 0, 1}), mechanism::revolute(0, up, {0, 1, 0}), mechanism::revolute(1, up, {0, 1, 0}),
      mechanism::revolute(2, {}, {1, 0, 0}), mechanism::revolute(3, out, {0, 1, 0}), mechanism::revolute(4, {}, {1, 0, 0})});
  const auto goal = mechanism::whole(5);
  std::vector<double> values{0.3, 0.4, 0.9, 0.2, 0.8, 0.1}, near{0.2, 0.5, 0.8, 0.2, 0.7, 0};
  const auto [columns, target] = arm.jacobian(values, 5);
  const auto found = arm.solutions(goal, target, near);
  const auto report = arm.reach_one({goal}, target, near);
  for (std::size_t i = 0; i < found[0].count; i++) {
    std::printf("solution %d: %.3f from the start\n", int(i), found[0].all[i].distance);
  }

  /* A scan from a body that moves by one metre in a second: all points, as if from where it began. */
  const dq8::trajectory path({0, 1}, std::vector{motion(), motion::translation_by({1, 0, 0})});
  std::vector<std::array<double, 3>> points{{0, 2, 0}, {0, 2, 0}};
  path.deskew({0, 0.5}, points, points);

  const bool right = std::fabs(hand[0] - 0.5) < 1e-4 && std::fabs(posed[0] - 0.5) < 1e-4 && columns.size() == 6 &&
                     found[0].count > 1 && report.outcome == DQ8_OUTCOME_CONVERGED &&
                     std::fabs(near[3] - found[0].all[0].values[3]) < 1e-3 && std::fabs(points[1][0] - 0.5) < 1e-9;
  std::puts(right ? "PASS" : "FAIL");
  return right ? 0 : 1;
} catch (const dq8::error &error) {
  std::puts(error.what());
  return 1;
}
