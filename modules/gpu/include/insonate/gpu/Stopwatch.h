#pragma once

#include <insonate/gpu/Context.h>

#include <memory>
#include <vector>

namespace insonate::gpu {

/// Measures durations of the card's work with time stamps of the card (GL_TIMESTAMP). The measurement makes the card
/// neither wait for the processor nor stop between parts of the work.
class Stopwatch {
 public:
  Stopwatch() = default;
  /// Makes a stopwatch that holds this many marks.
  static Result<Stopwatch> make(const CurrentContext& current, int marks);
  ~Stopwatch();
  Stopwatch(Stopwatch&& other) noexcept;
  Stopwatch& operator=(Stopwatch&& other) noexcept;

  /// Records the time at which the card finishes the work that has been queued so far. `mark` is the number of the time
  /// stamp, from 0.
  void mark(const CurrentContext& current, int mark) const;
  /// Returns the time in ms between two marks. Both must have been set since the last call. Waits until the card has
  /// reached them.
  double between_ms(const CurrentContext& current, int from, int to) const;

 private:
  std::shared_ptr<Context> context_;
  std::vector<unsigned> ids_;
};

}  // namespace insonate::gpu
