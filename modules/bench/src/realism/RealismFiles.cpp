#include "realism/BlindSet.h"
#include "report/CellTable.h"

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

namespace insonate {
namespace {

namespace fs = std::filesystem;

std::string fixedOrNone(double value, int digits) {
  return std::isfinite(value) ? bench::fixed(value, digits) : "n/a";
}

std::string rangeOf(double median, double low, double high) {
  return fixedOrNone(median, 3) + " [" + fixedOrNone(low, 3) + ", " + fixedOrNone(high, 3) + "]";
}

std::string areaOf(const RocArea& told) {
  return fixedOrNone(told.area, 2) + " (" + fixedOrNone(told.low, 2) + " to " + fixedOrNone(told.high, 2) + ")";
}

std::string page(const RealismBench& bench) {
  std::string text =
      "# Simulated and real images\n\n" + std::to_string(bench.real.size()) + " real and " +
      std::to_string(bench.simulated.size()) +
      " simulated images at 10 pixels per mm, at most 30 mm deep. ROC area: 0.5 cannot tell them apart, 0 or 1 always "
      "does; in brackets the 95 % interval. Floor: how far one real source lies from the others. Beyond: told better "
      "than "
      "that, with p below 0.05 after Holm's correction for " +
      std::to_string(bench.features.size()) +
      " features.\n\n"
      "A linear classifier of all features, cross-validated by leaving out one source at a time: ROC area " +
      areaOf(bench.classifier) +
      ".\n\n"
      "| feature | real median [p10, p90] | simulated | ROC area | floor | p | beyond "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const RealismFeature& f : bench.features)
    text += "| " + f.name + " | " + rangeOf(f.real, f.realLow, f.realHigh) + " | " +
            rangeOf(f.simulated, f.simulatedLow, f.simulatedHigh) + " | " + areaOf(f.told) + " | " +
            fixedOrNone(f.floor, 2) + " | " + fixedOrNone(f.p, 4) + " | " + (f.isBeyondFloor() ? "yes" : "no") + " |\n";
  return text +
         "\nThe blind test is in `blind/`; give that folder alone to readers. `key.csv` tells which is which; "
         "`bench realism --out DIR --ratings FILE...` scores what they found.\n";
}

std::string table(const RealismBench& bench) {
  std::string text =
      "feature,real,real_p10,real_p90,simulated,simulated_p10,simulated_p90,roc,roc_low,roc_high,floor,p,beyond_"
      "floor\n";
  for (const RealismFeature& f : bench.features) {
    text += '"' + f.name + '"';
    for (const double v : {f.real, f.realLow, f.realHigh, f.simulated, f.simulatedLow, f.simulatedHigh, f.told.area,
                           f.told.low, f.told.high, f.floor, f.p})
      text += "," + (std::isfinite(v) ? fixedOrNone(v, 5) : "");
    text += f.isBeyondFloor() ? ",yes\n" : ",no\n";
  }
  return text;
}

std::string keyOf(const std::vector<bench::BlindImage>& images) {
  std::string text = "number,simulated,source,about\n";
  for (std::size_t n = 0; n < images.size(); ++n)
    text += std::to_string(n + 1) + (images[n].simulated ? ",1,\"" : ",0,\"") + images[n].image->source + "\",\"" +
            images[n].image->about + "\"\n";
  return text;
}

/// The first two cells of each line as whole numbers, keyed by the first; comment lines (#) and the heading are
/// ignored.
Result<std::map<int, int>> numbersIn(const fs::path& file, int low, int high, const std::string& what) {
  std::ifstream stream(file);
  if (!stream) return fail("Could not read " + file.string() + ": check that it is there and that you may read it.");
  std::map<int, int> numbers;
  std::string line;
  for (int at = 1; std::getline(stream, line); ++at) {
    if (line.empty() || line == "\r" || line.front() == '#' || line.starts_with("number")) continue;
    int number = 0, value = 0;
    const char* end = line.data() + line.size();
    const auto first = std::from_chars(line.data(), end, number);
    const bool hasComma = first.ec == std::errc() && first.ptr != end && *first.ptr == ',';
    const auto second = hasComma ? std::from_chars(first.ptr + 1, end, value) : first;
    const std::string place = "Line " + std::to_string(at) + " of " + file.string();
    if (!hasComma || second.ec != std::errc() || value < low || value > high)
      return fail(place + " needs the number of an image and " + what + ".");
    if (!numbers.emplace(number, value).second)
      return fail(place + " rates image " + std::to_string(number) + " a second time.");
  }
  return numbers;
}

}  // namespace

Result<void> writeRealismBench(const RealismBench& bench, const fs::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail("Could not make the folder " + folder.string() + ": " + error.message() + ".");
  const std::vector<bench::BlindImage> images = bench::shuffled(bench);
  const auto blind = [&](const fs::path& beside) { return bench::writeBlindSet(images, beside); };
  if (auto ok = writeFolderAtomically(folder / "blind", blind); !ok) return ok;
  if (auto ok = writeAtomically(folder / "key.csv", keyOf(images)); !ok) return ok;
  if (auto ok = writeAtomically(folder / "features.csv", table(bench)); !ok) return ok;
  return writeAtomically(folder / "index.md", page(bench));
}

Result<BlindResult> scoreBlindTest(const fs::path& key, const std::vector<fs::path>& ratings) {
  const auto which = numbersIn(key, 0, 1, "0 or 1");
  if (!which) return tl::unexpected(which.error());
  BlindResult result;
  result.readers = int(ratings.size()), result.images = int(which->size());
  std::vector<ReaderRatings> readers;
  for (const fs::path& file : ratings) {
    const auto rated = numbersIn(file, 1, 6, "a rating from 1 to 6");
    if (!rated) return tl::unexpected(rated.error());
    ReaderRatings reader;
    double hits = 0, rejections = 0;
    for (const auto& [number, simulated] : *which) {
      const auto rating = rated->find(number);
      if (rating == rated->end())
        return fail(file.string() + " has no rating of image " + std::to_string(number) + ".");
      (simulated ? reader.positive : reader.negative).push_back(rating->second);
      if (simulated) hits += rating->second >= 4;
      if (!simulated) rejections += rating->second < 4;
    }
    for (const auto& [number, rating] : *rated)
      if (!which->contains(number))
        return fail(file.string() + " rates image " + std::to_string(number) + ", which the key does not list.");
    if (reader.positive.empty() || reader.negative.empty())
      return fail(key.string() + " lists images of one kind only.");
    result.sensitivity += hits / double(reader.positive.size()) / double(ratings.size());
    result.specificity += rejections / double(reader.negative.size()) / double(ratings.size());
    readers.push_back(std::move(reader));
  }
  result.told = readersRocArea(readers);
  return result;
}

}  // namespace insonate
