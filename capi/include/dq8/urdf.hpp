/* Robots from URDF files, for libraries that were installed with FEATURES=urdf. */
#ifndef DQ8_URDF_HPP
#define DQ8_URDF_HPP

#include "mechanism.hpp"

#if !defined(DQ8_URDF)
#error "the library reads no URDF files: install it by FEATURES=urdf capi/install.sh"
#endif

namespace dq8 {

/* A robot from a file: its joints, of which joint j carries link j, and its names. */
template <class T>
struct urdf {
  std::vector<typename mechanism<T>::joint> joints;
  std::vector<std::string> links, values;

  /* Reads the text of a file. Throws an error that says which line is wrong. */
  explicit urdf(const std::string &text) {
    const auto *bytes = reinterpret_cast<const std::uint8_t *>(text.data());
    char message[512] = "";
    const auto check = [&](dq8_status status) {
      if (status == DQ8_STATUS_URDF) throw error(status, std::string("dq8::urdf: ") + message);
      detail::check("urdf", status);
    };
    std::size_t count = 0, size = 0;
    check(dq8_urdf_size(bytes, text.size(), &count, &size, message, sizeof message));
    joints.resize(count);
    std::vector<char> names(size);
    check(read(bytes, text.size(), joints.data(), count, names.data(), size, message, sizeof message));
    for (std::size_t at = 0; at < size;) {
      auto &to = links.size() < count ? links : values;
      to.push_back(&names[at]);
      at += to.back().size() + 1;
    }
  }
  /* The index of a link. Throws if there is none of this name. */
  std::size_t link(const std::string &name) const {
    for (std::size_t i = 0; i < links.size(); i++) {
      if (links[i] == name) return i;
    }
    throw error(DQ8_STATUS_NO_LINK, "dq8::urdf::link: there is no link " + name);
  }

 private:
  template <class... Arguments>
  static dq8_status read(const std::uint8_t *text, std::size_t length, dq8_joint_f32 *joints, Arguments... arguments) {
    return dq8_urdf_joints_f32(text, length, joints, arguments...);
  }
  template <class... Arguments>
  static dq8_status read(const std::uint8_t *text, std::size_t length, dq8_joint_f64 *joints, Arguments... arguments) {
    return dq8_urdf_joints_f64(text, length, joints, arguments...);
  }
};

} // namespace dq8

#endif
