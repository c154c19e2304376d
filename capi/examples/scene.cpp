/*
 * A character, an arm and a scan in C++17.
 *
 *     c++ -std=c++17 scene.cpp $(pkg-config --cflags --libs dq8)
 */
#include <cmath>
#include <cstdio>

#include "dq8.hpp"

using motion = dq8::motion<double>;
using mechanism = dq8::mechanism<double>;

static bool near(double a, double b) { return std::fabs(a - b) < 1e-4; }

int main() try {
  const motion bone = motion::translation_by({1, 0, 0});

  /* A character of three joints: one pose, and a mesh of one vertex that follows two of them. */
  const dq8::skeleton skeleton({-1, 0, 1});
  const double turn = std::sqrt(0.5);
  const std::vector<motion> locals{motion::rotation_by({0, 0, turn, turn}), bone, bone};
  std::vector<motion> models(3), binds(3), palette(3), rest{motion(), bone, bone};
  skeleton.local_to_model(rest, rest);
  dq8::inverse(rest, binds);
  skeleton.palette(locals, binds, models, palette);
  const dq8::skin<double> sleeve(3, 2, {1, 2}, {0.5, 0.5});
  std::array<double, 3> vertex{2, 0, 0}, posed;
  sleeve.dual(palette, {vertex}, {posed});
  std::printf("the vertex is at %.3f %.3f %.3f\n", posed[0], posed[1], posed[2]);

  /* An arm of two hinges: where its tip is, how fast it moves, and which values bring it to a point. */
  const mechanism arm(std::vector{mechanism::revolute(-1, {}, {0, 0, 1}), mechanism::revolute(0, bone, {0, 0, 1}),
                                  mechanism::fixed(1, bone)});
  std::vector<double> values{0.3, 0.4};
  const auto [columns, tip] = arm.jacobian(values, 2);
  std::printf("the tip is at %.3f, its speed by the first hinge %.3f\n", tip.translation()[0], columns[0][4]);
  const auto report = arm.reach_one({mechanism::point(2)}, motion::translation_by({0.5, 1.2, 0}), values);
  const auto reached = arm.pose(values, 2).translation();

  /* A scan from a body that moves by one metre in a second: all points, as if from where it began. */
  const dq8::trajectory path({0, 1}, std::vector{motion(), bone});
  std::vector<std::array<double, 3>> points{{0, 2, 0}, {0, 2, 0}};
  path.deskew({0.0, 0.5}, points, points, dq8::trajectory_options().in_start());

  const bool right = near(posed[1], 2) && near(report.outcome, DQ8_OUTCOME_CONVERGED) && near(reached[1], 1.2) && near(points[1][0], 0.5);
  std::puts(right ? "PASS" : "FAIL");
  return right ? 0 : 1;
} catch (const dq8::error &error) {
  std::puts(error.what());
  return 1;
}
