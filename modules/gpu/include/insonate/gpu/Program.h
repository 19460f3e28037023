#pragma once

#include <insonate/gpu/Context.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate::gpu {

/// One field of a structure that is declared in both C++ and a shader.
struct Field {
  std::string_view name;  ///< name in the shader, e.g. "lines" or "channel[0].echo_dB"
  std::size_t offset;     ///< byte offset from the beginning of the C++ structure
};

/// A compute shader.
class Program {
 public:
  /// Compiles a shader: a line with the GLSL version, followed by the texts in `parts` in their order. Fails with the
  /// compiler's log.
  static Result<Program> make(const CurrentContext& current, std::string name, std::span<const std::string_view> parts);
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;

  const std::string& name() const { return name_; }

  /// Compares a shader's uniform block with the C++ structure of the same layout: names, offsets, number of fields,
  /// size. In `fields`, an array is represented by its first element, an array of structures by the fields of its first
  /// element. Fails with the first difference. Succeeds if the program does not use the block.
  Result<void> checkBlock(const CurrentContext& current, std::string_view block, std::span<const Field> fields,
                          std::size_t size) const;

  void setInt(const CurrentContext& current, std::string_view uniform, int value) const;
  /// Queues a run of the shader with these numbers of work groups. Work that is queued later reads the results of the
  /// run.
  void run(const CurrentContext& current, int groupsX, int groupsY = 1, int groupsZ = 1) const;

 private:
  Program(std::shared_ptr<Context> context, std::string name, unsigned id);
  std::shared_ptr<Context> context_;
  std::string name_;
  unsigned id_ = 0;
};

}  // namespace insonate::gpu
