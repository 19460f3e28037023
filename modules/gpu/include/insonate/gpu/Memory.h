#pragma once

#include <insonate/gpu/Context.h>

#include <array>
#include <cstddef>
#include <span>

namespace insonate::gpu {

/// Memory on the card.
class Buffer {
 public:
  Buffer() = default;
  /// Contents undefined. Fails when the card has no room for it or does not show so much to a shader.
  static Result<Buffer> make(const Current& current, std::size_t bytes);
  template <class T>
  static Result<Buffer> of(const Current& current, std::span<const T> values) {
    return filled(current, std::as_bytes(values));
  }
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;

  std::size_t bytes() const { return bytes_; }
  /// Replaces the whole contents, at most bytes(); running work still sees the old contents.
  void write(const Current& current, std::span<const std::byte> contents) const;
  /// Waits for running work. For tests; see ReadBack.
  void read(const Current& current, std::span<std::byte> contents) const;
  /// Binds as `layout(binding = slot) buffer` or, up to 16 KB, `layout(binding = slot) uniform`.
  void bindStorage(const Current& current, unsigned slot) const;
  void bindUniform(const Current& current, unsigned slot) const;

 private:
  friend class ReadBack;
  Buffer(std::shared_ptr<Context> context, std::size_t bytes, unsigned id);
  static Result<Buffer> filled(const Current& current, std::span<const std::byte> contents);
  std::shared_ptr<Context> context_;
  std::size_t bytes_ = 0;
  unsigned id_ = 0;
};

/// A table of pairs of floats, looked up by whole numbers: `layout(binding = slot) uniform sampler2D`, texelFetch().
class PairTexture {
 public:
  PairTexture() = default;
  ~PairTexture();
  PairTexture(PairTexture&& other) noexcept;
  PairTexture& operator=(PairTexture&& other) noexcept;

  /// `pairs` holds 2 * columns * rows floats, rows by rows. Fails beyond the card's largest texture. Allocates only
  /// when the size changes.
  Result<void> write(const Current& current, int columns, int rows, std::span<const float> pairs);
  void bind(const Current& current, unsigned slot) const;

 private:
  std::shared_ptr<Context> context_;
  unsigned id_ = 0;
  int columns_ = 0, rows_ = 0;
};

/// Fetches results while the card continues: up to two are in flight, each in memory of its own behind a fence.
class ReadBack {
 public:
  ReadBack() = default;
  /// Allocates room for two results of this many bytes.
  static Result<ReadBack> make(const Current& current, std::size_t bytes);
  ~ReadBack();
  ReadBack(ReadBack&& other) noexcept = default;
  ReadBack& operator=(ReadBack&& other) noexcept = default;

  bool full() const { return underWay_ == kSlots; }
  /// Has a part of a buffer copied once what runs now is done. Not when full.
  void begin(const Current& current, const Buffer& from, std::size_t offset, std::size_t bytes);
  /// Waits for the oldest transfer and copies its result. Fails when the card has not answered within ten seconds.
  Result<void> finish(const Current& current, std::span<std::byte> into);

 private:
  static constexpr int kSlots = 2;
  struct Slot {
    Buffer memory;
    void* fence = nullptr;
    std::size_t bytes = 0;
  };
  std::array<Slot, kSlots> slots_;
  int oldest_ = 0, underWay_ = 0;
};

}  // namespace insonate::gpu
