/*
 * What all of dq8's C++ shares: errors, views of arrays, blocks. Users include dq8.hpp, whose first comment has the rules.
 */
#ifndef DQ8_CORE_HPP
#define DQ8_CORE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../dq8.h"

namespace dq8 {

constexpr std::size_t nowhere = SIZE_MAX;

/* An error of a call. `what()` names the function, and the argument or the index that is wrong. `status` is the kind of the
   error. `index` is the wrong joint, vertex, time or the like, or `nowhere`. */
struct error : std::runtime_error {
  dq8_status status;
  std::size_t index;
  error(dq8_status kind, const std::string &text, std::size_t wrong = nowhere)
      : std::runtime_error(text), status(kind), index(wrong) {}
};

/* The number type of the element of an array, and how many numbers the element is made of. */
template <class Element>
struct record {
  using type = Element;
  static constexpr std::size_t size = 1;
};
template <class Element, std::size_t N>
struct record<Element[N]> {
  using type = typename record<Element>::type;
  static constexpr std::size_t size = N * record<Element>::size;
};
template <class Element, std::size_t N>
struct record<std::array<Element, N>> : record<Element[N]> {};

namespace detail {

/* The element of a range, with its const. */
template <class Range>
using element = std::remove_pointer_t<decltype(std::data(std::declval<Range &>()))>;
/* The number type of a range, without const. */
template <class Range>
using number = typename record<std::remove_const_t<element<Range>>>::type;

} // namespace detail

/* A view of numbers, or of other things, that something else owns. It is made of a pointer and a length, of a list in braces,
   or of anything with data() and size(): a vector, an array, std::span. Elements that are made of numbers, such as motions
   and std::array<T, 3>, become their numbers. */
template <class T>
class span {
  using value = std::remove_const_t<T>;
  template <class Element>
  static constexpr bool shows = std::is_same_v<typename record<std::remove_const_t<Element>>::type, value> &&
                                (std::is_const_v<T> || !std::is_const_v<Element>);

 public:
  span() = default;
  span(T *data, std::size_t size) : data_(data), size_(size) {}
  template <class Range, class Element = detail::element<Range>, class = std::enable_if_t<shows<Element>>>
  span(Range &&range)
      : data_(reinterpret_cast<T *>(std::data(range))),
        size_(std::size(range) * record<std::remove_const_t<Element>>::size) {}
  template <class Own = T, class = std::enable_if_t<std::is_const_v<Own>>>
  span(std::initializer_list<value> list) : span(std::data(list), list.size()) {}
  T *data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T *begin() const { return data_; }
  T *end() const { return data_ + size_; }
  T &operator[](std::size_t index) const { return data_[index]; }

 private:
  T *data_ = nullptr;
  std::size_t size_ = 0;
};

namespace detail {

/* The functions of dq8.h for a number type; abi.hpp fills it in. */
template <class T>
struct abi;

/* A type from which no template parameter is deduced. */
template <class T>
struct known {
  using type = T;
};
template <class T>
using same = typename known<T>::type;

/* An input beside an output, from which it has its number type. */
template <class Out>
using in = span<const number<Out>>;

inline void check(const char *function, dq8_status status, std::size_t index = nowhere) {
  if (status == DQ8_STATUS_OK) return;
  std::string text = std::string("dq8::") + function + ": " + dq8_status_text(status);
  if (index != nowhere) text += " (index " + std::to_string(index) + ")";
  throw error(status, text, index);
}
[[noreturn]] inline void refuse(const char *function, const char *argument, std::size_t has, const std::string &must) {
  throw error(DQ8_STATUS_LENGTH, std::string("dq8::") + function + ": " + argument + " has length " + std::to_string(has) +
                                     ", and must have " + must);
}
inline void length(const char *function, const char *argument, std::size_t has, std::size_t must) {
  if (has != must) refuse(function, argument, has, "length " + std::to_string(must));
}
/* Checks an array that may be left out. */
inline void length_if(const char *function, const char *argument, std::size_t has, std::size_t must) {
  if (has != 0) length(function, argument, has, must);
}
/* Returns the number of things of `each` numbers in an array. */
inline std::size_t things(const char *function, const char *argument, std::size_t has, std::size_t each) {
  if (each == 0 ? has != 0 : has % each != 0) {
    refuse(function, argument, has, each == 0 ? std::string("length 0") : "a multiple of " + std::to_string(each));
  }
  return each == 0 ? 0 : has / each;
}
/* Returns the pointer of an array, or null if the array has been left out. */
template <class T>
T *maybe(span<T> array) {
  return array.empty() ? nullptr : array.data();
}

/* Whether the object that this is part of still has its memory, or has been moved away. */
class owner {
 public:
  owner() = default;
  owner(owner &&other) noexcept : lives_(std::exchange(other.lives_, false)) {}
  owner &operator=(owner &&other) noexcept {
    const bool lived = std::exchange(other.lives_, false);
    // What is moved to itself loses its memory.
    lives_ = lived && this != &other;
    return *this;
  }
  void check(const char *noun) const {
    if (!lives_) throw error(DQ8_STATUS_UNKNOWN_VALUE, std::string("dq8::") + noun + ": this object has been moved away");
  }

 private:
  bool lives_ = true;
};

/* A struct of dq8.h that points to memory, such as a mechanism. */
template <class Made>
class made {
 public:
  /* Returns the struct for the function that fills it in. */
  Made *fill() { return &it_; }
  /* Returns the struct. Throws if it has been moved away. */
  const Made *get(const char *noun) const { return owner_.check(noun), &it_; }

 private:
  Made it_{};
  owner owner_;
};

} // namespace detail

/* The name of the instruction set in use, for logs. */
inline const char *backend_name() { return dq8_backend_name(); }
/* Limits the instruction set to `most`, one of enum dq8_backend, for all threads. */
inline void backend_limit(std::int32_t most) { detail::check("backend_limit", dq8_backend_limit(most)); }
/* Makes results the same on every machine, bit by bit, for all threads. */
inline void set_reproducible(bool reproducible) { detail::check("set_reproducible", dq8_set_reproducible(reproducible)); }

} // namespace dq8

#endif
