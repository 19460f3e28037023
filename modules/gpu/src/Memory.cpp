#include <insonate/gpu/Memory.h>

#include <epoxy/gl.h>

#include <cstring>
#include <utility>

namespace insonate::gpu {

Buffer::Buffer(std::shared_ptr<Context> context, std::size_t bytes, unsigned id)
    : context_(std::move(context)), bytes_(bytes), id_(id) {}

Buffer::Buffer(Buffer&& other) noexcept
    : context_(std::move(other.context_)), bytes_(std::exchange(other.bytes_, 0)), id_(std::exchange(other.id_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(context_, other.context_), std::swap(bytes_, other.bytes_), std::swap(id_, other.id_);
  return *this;
}

Buffer::~Buffer() {
  if (id_ == 0) return;
  if (const auto current = context_->use()) glDeleteBuffers(1, &id_);
}

Result<Buffer> Buffer::make(const CurrentContext& current, std::size_t bytes) {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (bytes > std::size_t(most))
    return fail("The graphics card gives a shader access to at most " + std::to_string(most >> 20) +
                " MB at once, and " + std::to_string((bytes >> 20) + 1) + " MB are needed.");
  Buffer buffer(current.context(), bytes, 0);
  glGenBuffers(1, &buffer.id_);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id_);
  glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(std::max<std::size_t>(bytes, 16)), nullptr, GL_DYNAMIC_DRAW);
  if (auto ok = current.check(); !ok) return tl::unexpected(ok.error());
  return buffer;
}

Result<Buffer> Buffer::filled(const CurrentContext& current, std::span<const std::byte> contents) {
  auto buffer = make(current, contents.size());
  if (buffer) buffer->write(current, contents);
  return buffer;
}

void Buffer::write(const CurrentContext&, std::span<const std::byte> contents) const {
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(contents.size()), contents.data());
}

void Buffer::read(const CurrentContext&, std::span<std::byte> contents) const {
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(contents.size()), contents.data());
}

void Buffer::bindStorage(const CurrentContext&, unsigned slot) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, slot, id_);
}

void Buffer::bindUniform(const CurrentContext&, unsigned slot) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, slot, id_);
}

PairTexture::PairTexture(PairTexture&& other) noexcept {
  *this = std::move(other);
}

PairTexture& PairTexture::operator=(PairTexture&& other) noexcept {
  std::swap(context_, other.context_), std::swap(id_, other.id_);
  std::swap(columns_, other.columns_), std::swap(rows_, other.rows_);
  return *this;
}

PairTexture::~PairTexture() {
  if (id_ == 0) return;
  if (const auto current = context_->use()) glDeleteTextures(1, &id_);
}

Result<void> PairTexture::write(const CurrentContext& current, int columns, int rows, std::span<const float> pairs) {
  int most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (std::max(columns, rows) > most)
    return fail("The graphics card supports textures of at most " + std::to_string(most) +
                " points in width and height.");
  context_ = current.context();
  if (id_ == 0) glGenTextures(1, &id_);
  glBindTexture(GL_TEXTURE_2D, id_);
  if (columns != columns_ || rows != rows_) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, columns, rows, 0, GL_RG, GL_FLOAT, pairs.data());
    // Without this setting a texture without mipmaps reads as black.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    columns_ = columns, rows_ = rows;
    return current.check();
  }
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, columns, rows, GL_RG, GL_FLOAT, pairs.data());
  return {};
}

void PairTexture::bind(const CurrentContext&, unsigned slot) const {
  glActiveTexture(GL_TEXTURE0 + slot);
  glBindTexture(GL_TEXTURE_2D, id_);
}

Result<ReadBack> ReadBack::make(const CurrentContext& current, std::size_t bytes) {
  ReadBack readBack;
  for (Slot& slot : readBack.slots_) {
    auto memory = Buffer::make(current, bytes);
    if (!memory) return tl::unexpected(memory.error());
    slot.memory = std::move(*memory);
    // Written by the card, read by the processor.
    glBindBuffer(GL_COPY_WRITE_BUFFER, slot.memory.id_);
    glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(bytes), nullptr, GL_STREAM_READ);
  }
  if (auto ok = current.check(); !ok) return tl::unexpected(ok.error());
  return readBack;
}

ReadBack::~ReadBack() = default;

void ReadBack::begin(const CurrentContext&, const Buffer& from, std::size_t offset, std::size_t bytes) {
  Slot& slot = slots_[(oldest_ + underWay_++) % kSlots];
  glBindBuffer(GL_COPY_READ_BUFFER, from.id_);
  glBindBuffer(GL_COPY_WRITE_BUFFER, slot.memory.id_);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GLintptr(offset), 0, GLsizeiptr(bytes));
  slot.bytes = bytes;
  slot.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
}

Result<void> ReadBack::finish(const CurrentContext& current, std::span<std::byte> into) {
  constexpr GLuint64 kPatience_ns = 10'000'000'000;
  Slot& slot = slots_[oldest_];
  oldest_ = (oldest_ + 1) % kSlots;
  --underWay_;
  const auto fence = static_cast<GLsync>(std::exchange(slot.fence, nullptr));
  const unsigned state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience_ns);
  glDeleteSync(fence);
  if (auto ok = current.check(); !ok) return ok;
  if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED)
    return fail("The graphics card does not answer.");
  glBindBuffer(GL_COPY_WRITE_BUFFER, slot.memory.id_);
  const void* mapped = glMapBufferRange(GL_COPY_WRITE_BUFFER, 0, GLsizeiptr(slot.bytes), GL_MAP_READ_BIT);
  if (!mapped) return fail("The results could not be read from the graphics card.");
  std::memcpy(into.data(), mapped, std::min(into.size(), slot.bytes));
  glUnmapBuffer(GL_COPY_WRITE_BUFFER);
  return {};
}

}  // namespace insonate::gpu
