#pragma once

#include <insonate/gpu/Context.h>

#include <memory>
#include <vector>

namespace insonate::gpu {

/// Measures on the card how long parts of its work take (GL_TIMESTAMP). The card neither waits for the processor nor
/// stops between the parts.
class Stopwatch {
 public:
  Stopwatch() = default;
  /// Makes a stopwatch that holds this many marks.
  static Result<Stopwatch> make(const Current& current, int marks);
  ~Stopwatch();
  Stopwatch(Stopwatch&& other) noexcept;
  Stopwatch& operator=(Stopwatch&& other) noexcept;

  /// Notes the time at which the card has finished the work that is queued so far.
  void mark(const Current& current, int mark) const;
  /// Returns the milliseconds on the card between two marks, both set since the last call. Waits until the card has
  /// passed them.
  double between_ms(const Current& current, int from, int to) const;

 private:
  std::shared_ptr<Context> context_;
  std::vector<unsigned> ids_;
};

}  // namespace insonate::gpu
