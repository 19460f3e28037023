#pragma once

#include <insonate/gpu/Context.h>

#include <array>
#include <cstddef>
#include <span>

namespace insonate::gpu {

/// A buffer in the card's memory.
class Buffer {
 public:
  Buffer() = default;
  /// Allocates a buffer with undefined contents. Fails if the card has too little memory, or if shaders cannot access a
  /// buffer of this size.
  static Result<Buffer> make(const CurrentContext& current, std::size_t bytes);
  template <class T>
  static Result<Buffer> of(const CurrentContext& current, std::span<const T> values) {
    return filled(current, std::as_bytes(values));
  }
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;

  std::size_t bytes() const { return bytes_; }
  /// Writes `contents`, at most bytes() long, to the beginning of the buffer. Work that is already running on the card
  /// still reads the old contents.
  void write(const CurrentContext& current, std::span<const std::byte> contents) const;
  /// Waits until the card has finished its work, then copies the buffer into `contents`. For tests only, since the card
  /// idles during the copy; ReadBack copies while the card works.
  void read(const CurrentContext& current, std::span<std::byte> contents) const;
  /// bindStorage() binds the buffer to the block that a shader declares as `layout(binding = slot) buffer`.
  /// bindUniform() binds the buffer to a `layout(binding = slot) uniform` block of up to 16 KB.
  void bindStorage(const CurrentContext& current, unsigned slot) const;
  void bindUniform(const CurrentContext& current, unsigned slot) const;

 private:
  friend class ReadBack;
  Buffer(std::shared_ptr<Context> context, std::size_t bytes, unsigned id);
  static Result<Buffer> filled(const CurrentContext& current, std::span<const std::byte> contents);
  std::shared_ptr<Context> context_;
  std::size_t bytes_ = 0;
  unsigned id_ = 0;
};

/// A two-dimensional table in the card's memory. Each entry is a pair of floats. Shaders declare it as `layout(binding
/// = slot) uniform sampler2D` and read it by integer indices with texelFetch().
class PairTexture {
 public:
  PairTexture() = default;
  ~PairTexture();
  PairTexture(PairTexture&& other) noexcept;
  PairTexture& operator=(PairTexture&& other) noexcept;

  /// Replaces the table: `pairs` holds 2 * columns * rows floats, row by row. Fails if the table exceeds the card's
  /// maximum texture size. Allocates only if the size changes.
  Result<void> write(const CurrentContext& current, int columns, int rows, std::span<const float> pairs);
  void bind(const CurrentContext& current, unsigned slot) const;

 private:
  std::shared_ptr<Context> context_;
  unsigned id_ = 0;
  int columns_ = 0, rows_ = 0;
};

/// Copies results from the card to the processor's memory while the card continues to work. Up to two transfers can be
/// in progress, each into a buffer of its own; an OpenGL fence tells when a transfer is finished.
class ReadBack {
 public:
  ReadBack() = default;
  /// Allocates memory for two results of this many bytes.
  static Result<ReadBack> make(const CurrentContext& current, std::size_t bytes);
  ~ReadBack();
  ReadBack(ReadBack&& other) noexcept = default;
  ReadBack& operator=(ReadBack&& other) noexcept = default;

  /// Tells whether two transfers are in progress; finish() must then be called before begin().
  bool full() const { return underWay_ == kSlots; }
  /// Queues a copy of a part of a buffer. The card makes the copy after the work that is already queued. Do not call
  /// this function when full() is true.
  void begin(const CurrentContext& current, const Buffer& from, std::size_t offset, std::size_t bytes);
  /// Waits for the oldest transfer and copies its result. Fails if the card has not finished it within ten seconds.
  Result<void> finish(const CurrentContext& current, std::span<std::byte> into);

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
