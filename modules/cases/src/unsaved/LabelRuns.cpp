#include <insonate/cases/UnsavedWork.h>

#include <algorithm>
#include <cstring>

namespace insonate {
namespace {

constexpr int kBitsPerByte = 7;
constexpr std::uint8_t kMore = 0x80;

void appendNumber(LabelRuns& runs, std::size_t number) {
  for (; number >= kMore; number >>= kBitsPerByte) runs.push_back(std::uint8_t(number) | kMore);
  runs.push_back(std::uint8_t(number));
}

/// Reads runs; after an error, isGood() is false.
class RunReader {
 public:
  explicit RunReader(const LabelRuns& runs) : runs_(runs) {}
  bool atEnd() const { return at_ == runs_.size(); }
  bool isGood() const { return good_; }

  std::uint8_t byte() {
    if (at_ < runs_.size()) return runs_[at_++];
    good_ = false;
    return 0;
  }
  std::size_t number() {
    constexpr int kLargest_bits = 56;
    std::size_t number = 0;
    for (int shift = 0; shift < kLargest_bits; shift += kBitsPerByte) {
      const std::uint8_t next = byte();
      number |= std::size_t(next & ~kMore) << shift;
      if (!(next & kMore)) return number;
    }
    good_ = false;
    return 0;
  }

 private:
  const LabelRuns& runs_;
  std::size_t at_ = 0;
  bool good_ = true;
};

/// Returns the first index from `at` on at which the maps differ; the size if there is none.
std::size_t nextDifference(const std::vector<std::uint8_t>& from, const std::vector<std::uint8_t>& to, std::size_t at) {
  // Most blocks are equal, and memcmp is much faster than a loop over voxels.
  constexpr std::size_t kBlock = 4096;
  const auto isSame = [&](std::size_t count) { return std::memcmp(from.data() + at, to.data() + at, count) == 0; };
  while (at + kBlock <= to.size() && isSame(kBlock)) at += kBlock;
  while (at < to.size() && from[at] == to[at]) ++at;
  return at;
}

}  // namespace

LabelRuns runsBetween(const std::vector<std::uint8_t>& from, const std::vector<std::uint8_t>& to) {
  const std::vector<std::uint8_t> background(from.empty() ? to.size() : 0);
  const auto& base = from.empty() ? background : from;
  LabelRuns runs;
  std::size_t last = 0;
  for (std::size_t first = nextDifference(base, to, 0); first < to.size(); first = nextDifference(base, to, last)) {
    std::size_t end = first + 1;
    while (end < to.size() && to[end] == to[first] && base[end] != to[end]) ++end;
    appendNumber(runs, first - last);
    appendNumber(runs, end - first);
    runs.push_back(to[first]);
    last = end;
  }
  return runs;
}

Result<void> applyRuns(const LabelRuns& runs, std::vector<std::uint8_t>& labels) {
  RunReader reader(runs);
  std::size_t at = 0;
  while (!reader.atEnd()) {
    const std::size_t gap = reader.number(), length = reader.number();
    const std::uint8_t label = reader.byte();
    if (!reader.isGood() || gap > labels.size() - at || length > labels.size() - at - gap)
      return fail("The unsaved labels do not fit the case. Nothing was changed.");
    std::fill_n(labels.begin() + std::ptrdiff_t(at + gap), length, label);
    at += gap + length;
  }
  return {};
}

}  // namespace insonate
