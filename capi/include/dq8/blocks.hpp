/* Blocks: arrays in which several things lie component after component, which is the fastest form. */
#ifndef DQ8_BLOCKS_HPP
#define DQ8_BLOCKS_HPP

#include <memory>
#include <new>

#include "abi.hpp"

namespace dq8 {

/* Blocks of `lanes` things of some components, which own their memory. A default-constructed or moved-from object has none. */
template <class T>
class blocks {
  using abi = detail::abi<T>;
  static constexpr std::size_t line = 64;
  struct release {
    void operator()(T *memory) const { ::operator delete(memory, std::align_val_t(line)); }
  };

 public:
  blocks() = default;
  /* Makes `count` blocks, filled with zeros. float has blocks of 8 and 16 lanes, double of 4 and 8. */
  blocks(std::size_t lanes, std::size_t components, std::size_t count)
      : lanes_(lanes), components_(components), count_(count), size_(abi::block_size(lanes, components)) {
    const bool known = lanes == line / sizeof(T) || lanes == line / 2 / sizeof(T);
    detail::check("blocks", known ? DQ8_STATUS_OK : DQ8_STATUS_LANES);
    if (size_ != 0 && count > PTRDIFF_MAX / sizeof(T) / size_) detail::check("blocks", DQ8_STATUS_TOO_LARGE);
    memory_.reset(static_cast<T *>(::operator new(count * size_ * sizeof(T), std::align_val_t(line))));
    for (std::size_t i = 0; i < count * size_; i++) memory_.get()[i] = T(0);
  }
  blocks(blocks &&other) noexcept { *this = std::move(other); }
  blocks &operator=(blocks &&other) noexcept {
    lanes_ = std::exchange(other.lanes_, 0), components_ = std::exchange(other.components_, 0);
    count_ = std::exchange(other.count_, 0), size_ = std::exchange(other.size_, 0);
    memory_ = std::move(other.memory_);
    return *this;
  }
  /* Packs poses, [instance][joint], into [block of instances][joint]. */
  static blocks pack(std::size_t lanes, std::size_t joints, span<const T> poses) {
    const std::size_t instances = detail::things("blocks::pack", "poses", poses.size(), 8 * joints);
    blocks packed(lanes, 8, (instances + lanes - (lanes != 0)) / (lanes + (lanes == 0)) * joints);
    detail::check("blocks::pack", abi::pack(lanes, joints, poses.data(), poses.size() / 8, packed.start(), packed.count_));
    return packed;
  }
  /* Unpacks poses, [block of instances][joint], into [instance][joint]. Lanes after the last instance are ignored. */
  void unpack(std::size_t joints, span<T> poses) const {
    const std::size_t count = detail::things("blocks::unpack", "poses", poses.size(), 8);
    detail::check("blocks::unpack", abi::unpack(has(8, "blocks::unpack"), joints, start(), count_, poses.data(), count));
  }
  /* Packs the links of one long chain. */
  static blocks pack_chain(std::size_t lanes, span<const T> links) {
    const std::size_t count = detail::things("blocks::pack_chain", "links", links.size(), 8);
    blocks packed(lanes, 8, (count + lanes - (lanes != 0)) / (lanes + (lanes == 0)));
    detail::check("blocks::pack_chain", abi::pack_chain(lanes, links.data(), count, packed.start(), packed.count_));
    return packed;
  }
  /* Unpacks the links of one long chain. */
  void unpack_chain(span<T> links) const {
    const std::size_t count = detail::things("blocks::unpack_chain", "links", links.size(), 8);
    detail::check("blocks::unpack_chain",
                  abi::unpack_chain(has(8, "blocks::unpack_chain"), start(), count_, links.data(), count));
  }

  std::size_t lanes() const { return lanes_; }
  std::size_t components() const { return components_; }
  /* The number of blocks. */
  std::size_t count() const { return count_; }
  /* A component of one thing. */
  T &at(std::size_t block, std::size_t lane, std::size_t component) {
    return memory_.get()[place(block, lane, component)];
  }
  const T &at(std::size_t block, std::size_t lane, std::size_t component) const {
    return memory_.get()[place(block, lane, component)];
  }
  /* The numbers of all blocks, with what fills blocks up to whole 64 bytes. */
  span<T> numbers() { return {memory_.get(), count_ * size_}; }
  span<const T> numbers() const { return {memory_.get(), count_ * size_}; }

  /* Returns the number of lanes, after it has checked the number of components, for `function`. */
  std::size_t has(std::size_t components, const char *function) const {
    if (components_ != components) {
      throw error(DQ8_STATUS_LENGTH, std::string("dq8::") + function + ": blocks of " + std::to_string(components_) +
                                         " components where things have " + std::to_string(components));
    }
    return lanes_;
  }
  /* Checks an argument of `function` beside the blocks of its output. */
  template <class Out>
  void beside(const Out &out, std::size_t components, const char *function, const char *argument) const {
    has(components, function);
    detail::length(function, argument, count_, out.count());
    if (lanes_ != out.lanes()) {
      throw error(DQ8_STATUS_LANES, std::string("dq8::") + function + ": " + argument + " has blocks of " +
                                        std::to_string(lanes_) + " lanes, and out of " + std::to_string(out.lanes()));
    }
  }

 private:
  T *start() const { return memory_.get(); }
  std::size_t place(std::size_t block, std::size_t lane, std::size_t component) const {
    if (block >= count_ || lane >= lanes_ || component >= components_) {
      throw std::out_of_range("dq8::blocks::at: there is no such block, lane or component");
    }
    return block * size_ + component * lanes_ + lane;
  }

  std::size_t lanes_ = 0, components_ = 0, count_ = 0, size_ = 0;
  std::unique_ptr<T, release> memory_;
};

} // namespace dq8

#endif
