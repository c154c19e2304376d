/* A robot from its file: where its tool is and how it moves, and which values bring it to a target. */
#include <fstream>
#include <iostream>
#include <sstream>

#include "dq8.hpp"
#include "dq8/urdf.hpp"

using motion = dq8::motion<double>;

int main(int count, char **arguments) try {
  if (count != 3) throw std::runtime_error("usage: robot FILE.urdf TOOL");
  std::ostringstream text;
  text << std::ifstream(arguments[1]).rdbuf();
  const dq8::urdf<double> file(text.str());
  const dq8::mechanism<double> robot(file.joints);
  const std::size_t tool = file.link(arguments[2]);

  /* Where the tool is, and how fast if every joint turns at 0.1 radians a second. */
  std::vector<double> values(robot.values(), 0.3);
  const auto [columns, pose] = robot.jacobian(values, tool);
  const auto [x, y, z] = pose.translation();
  double speed = 0;
  for (const auto &column : columns) speed += 0.1 * column[5];
  std::cout << arguments[2] << " at " << x << " " << y << " " << z << ", rising at " << speed << "\n";

  /* A line of a hundred targets, five centimetres up, followed from where it is. */
  auto options = robot.default_options();
  options.restarts = 0;
  for (int step = 1; step <= 100; step++) {
    const motion target = motion::translation_by({0, 0, 0.0005 * step}) * pose;
    const auto report = robot.reach_one({robot.whole(tool)}, target, values, options);
    if (report.outcome != DQ8_OUTCOME_CONVERGED) throw std::runtime_error("step " + std::to_string(step) + " is not reached");
  }

  /* All ways to hold the tool there. */
  const auto found = robot.solutions(robot.whole(tool), robot.pose(values, tool), values)[0];
  for (std::size_t i = 0; i < found.count; i++) std::cout << "a way " << found.all[i].distance << " radians away\n";
  std::cout << (found.count > 0 ? "PASS" : "FAIL") << std::endl;
} catch (const std::exception &error) {
  std::cerr << error.what() << "\n";
  return 1;
}
