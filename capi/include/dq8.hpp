/*
 * dq8 for C++17. dq8.h has the formulas and conventions.
 *
 * Nouns.   motion, blocks, skeleton, plan, clips, mechanism, skin, trajectory and spline own their memory. All but motions
 *          can be moved but not copied; what has been moved away throws.
 * Arrays.  An argument is anything with data() and size(): a vector, an array, std::span, dq8::span, or a list in braces. Its
 *          elements are numbers, or are made of numbers: motions, std::array<double, 3>. The output decides between float and
 *          double. Lengths are checked.
 * Errors.  dq8::error says which function, and which argument or index is wrong.
 */
#ifndef DQ8_HPP
#define DQ8_HPP

#include "dq8/arrays.hpp"
#include "dq8/clips.hpp"
#include "dq8/fit.hpp"
#include "dq8/hierarchy.hpp"
#include "dq8/mechanism.hpp"
#include "dq8/motion.hpp"
#include "dq8/skin.hpp"
#include "dq8/trajectory.hpp"
#if defined(DQ8_URDF)
#include "dq8/urdf.hpp"
#endif

#endif
