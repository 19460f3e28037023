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
  /// Compiles the shader text in `parts`, concatenated in this order, after a line with the GLSL version. Fails with
  /// the compiler's log.
  static Result<Program> make(const Current& current, std::string name, std::span<const std::string_view> parts);
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;

  const std::string& name() const { return name_; }

  /// Compares a shader's uniform block with the C++ structure of the same layout: names, offsets, number of fields,
  /// size. Arrays are represented by their first element, arrays of structures by the fields of the first. Fails with
  /// the first difference. A program that does not use the block passes.
  Result<void> checkBlock(const Current& current, std::string_view block, std::span<const Field> fields,
                          std::size_t size) const;

  void setInt(const Current& current, std::string_view uniform, int value) const;
  /// Runs the given number of work groups; work that is queued later sees the results.
  void run(const Current& current, int groupsX, int groupsY = 1, int groupsZ = 1) const;

 private:
  Program(std::shared_ptr<Context> context, std::string name, unsigned id);
  std::shared_ptr<Context> context_;
  std::string name_;
  unsigned id_ = 0;
};

}  // namespace insonate::gpu
