#include "realism/RealismPage.h"
#include "report/CellTable.h"

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/ultrasound/SetupText.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

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

std::string comparisonText(const RealismComparison& comparison) {
  std::string text =
      "## " + std::string(nameOf(comparison.probe)) + " probe\n\n" + std::to_string(comparison.real) + " real and " +
      std::to_string(comparison.simulated) +
      " simulated images. A linear classifier of all features, cross-validated by leaving out one source "
      "at a time: ROC area " +
      areaOf(comparison.classifier) +
      ".\n\n| feature | real median [p10, p90] | simulated | ROC area | floor | p | beyond "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const RealismFeature& f : comparison.features)
    text += "| " + f.name + " | " + rangeOf(f.real, f.realLow, f.realHigh) + " | " +
            rangeOf(f.simulated, f.simulatedLow, f.simulatedHigh) + " | " + areaOf(f.separation) + " | " +
            fixedOrNone(f.floor, 2) + " | " + fixedOrNone(f.p, 4) + " | " + (f.exceedsFloor() ? "yes" : "no") + " |\n";
  return text + "\n";
}

std::string page(const RealismBench& bench) {
  std::string text =
      "# Simulated and real images\n\n" + std::to_string(bench.real.size()) + " real and " +
      std::to_string(bench.simulated.size()) +
      " simulated images, measured at 10 pixels per mm, at most 30 mm deep. ROC area: 0.5 cannot distinguish them, 0 "
      "or "
      "1 always does; in brackets the 95 % interval. Floor: how far one real source lies from the others. Beyond: "
      "distinguished better than that, with p below 0.05 after Holm's correction for all features of this page.\n\n";
  if (bench.comparisons.empty())
    text += "The list has no real images of the probes that were simulated: there is nothing to compare.\n\n";
  for (const RealismComparison& comparison : bench.comparisons) text += comparisonText(comparison);
  return text +
         "`index.html` shows the same with the images. The blind test is in `blind/`; give that folder alone to "
         "readers. "
         "`key.csv` states which is which; `bench realism --out DIR --ratings FILE...` scores the ratings.\n";
}

std::string table(const RealismBench& bench) {
  std::string text =
      "probe,feature,real,real_p10,real_p90,simulated,simulated_p10,simulated_p90,roc,roc_low,roc_high,floor,p,beyond_"
      "floor\n";
  for (const RealismComparison& comparison : bench.comparisons)
    for (const RealismFeature& f : comparison.features) {
      text += std::string(nameOf(comparison.probe)) + ",\"" + f.name + '"';
      for (const double v : {f.real, f.realLow, f.realHigh, f.simulated, f.simulatedLow, f.simulatedHigh,
                             f.separation.area, f.separation.low, f.separation.high, f.floor, f.p})
        text += "," + (std::isfinite(v) ? fixedOrNone(v, 5) : "");
      text += f.exceedsFloor() ? ",yes\n" : ",no\n";
    }
  return text;
}

std::string keyOf(const std::vector<bench::BlindImage>& images) {
  std::string text = "number,simulated,probe,plane,frames,source,about\n";
  for (std::size_t n = 0; n < images.size(); ++n) {
    const SourceImage& image = *images[n].image;
    text += std::to_string(n + 1) + (images[n].simulated ? ",1," : ",0,") + std::string(nameOf(image.probe)) + "," +
            std::string(image.plane ? nameOf(*image.plane) : "") + "," +
            std::to_string(std::max<std::size_t>(1, image.frames.size())) + ",\"" + image.source + "\",\"" +
            image.about + "\"\n";
  }
  return text;
}

/// A line of a file whose first two cells are whole numbers.
struct NumberedLine {
  int value = 0;
  std::vector<std::string> further;  ///< cells after the second; text in quotes is not recognized as such
};

/// The lines, keyed by their first cell; comment lines (#) and the heading are ignored.
Result<std::map<int, NumberedLine>> numbersIn(const fs::path& file, int low, int high, const std::string& what) {
  std::ifstream stream(file);
  if (!stream) return fail("Could not read " + file.string() + ": check that it is there and that you may read it.");
  std::map<int, NumberedLine> numbers;
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
    NumberedLine read{value, {}};
    std::istringstream rest(std::string(second.ptr, end));
    for (std::string cell; std::getline(rest, cell, ',');) read.further.push_back(std::move(cell));
    if (!read.further.empty()) read.further.erase(read.further.begin());  // what follows the second number
    if (!numbers.emplace(number, std::move(read)).second)
      return fail(place + " rates image " + std::to_string(number) + " a second time.");
  }
  return numbers;
}

/// Names of the groups to which an image of the key belongs: probe, plane, still or clip. Keys from before November
/// 2026 have none.
std::vector<std::string> groupsOf(const NumberedLine& image) {
  if (image.further.size() < 5) return {};
  std::vector<std::string> groups{image.further[0]};
  if (!image.further[1].empty()) groups.push_back(image.further[1]);
  groups.push_back(image.further[2] == "1" ? "stills" : "clips");
  return groups;
}

/// Result by group, if the images do not all belong to it.
std::vector<BlindGroup> groupResults(const std::map<int, NumberedLine>& key,
                                     const std::vector<std::map<int, NumberedLine>>& ratings) {
  std::map<std::string, std::vector<int>> members;
  for (const auto& [number, image] : key)
    for (const std::string& group : groupsOf(image)) members[group].push_back(number);
  std::vector<BlindGroup> groups;
  for (const auto& [name, numbers] : members) {
    BlindGroup group{.name = name, .separation = {}};
    for (const int number : numbers) ++(key.at(number).value ? group.simulated : group.real);
    if (numbers.size() == key.size() || group.real == 0 || group.simulated == 0) continue;
    std::vector<ReaderRatings> readers;
    for (const auto& rated : ratings) {
      ReaderRatings& reader = readers.emplace_back();
      for (const int number : numbers)
        (key.at(number).value ? reader.positive : reader.negative).push_back(rated.at(number).value);
    }
    group.separation = readersRocArea(readers);
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Removes images and key of an earlier run if this run has none.
Result<void> removeFormer(const fs::path& folder, std::initializer_list<const char*> names) {
  std::error_code error;
  for (const char* name : names) {
    fs::remove_all(folder / name, error);
    if (error) return fail("Could not remove " + (folder / name).string() + ": " + error.message() + ".");
  }
  return {};
}

}  // namespace

Result<void> writeRealismBench(const RealismBench& bench, const fs::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail("Could not make the folder " + folder.string() + ": " + error.message() + ".");
  const bench::BlindImages images = bench::blindImages(bench);
  if (!images.matched.empty()) {
    const auto blind = [&](const fs::path& beside) { return bench::writeBlindSet(images.matched, beside); };
    if (auto ok = writeFolderAtomically(folder / "blind", blind); !ok) return ok;
    if (auto ok = writeAtomically(folder / "key.csv", keyOf(images.matched)); !ok) return ok;
  } else if (auto ok = removeFormer(folder, {"blind", "key.csv"}); !ok) {
    return ok;
  }
  if (!images.unmatched.empty()) {
    const auto others = [&](const fs::path& beside) -> Result<void> {
      const auto written = bench::writeImages(images.unmatched, beside);
      return written ? Result<void>{} : tl::unexpected(written.error());
    };
    if (auto ok = writeFolderAtomically(folder / "unmatched", others); !ok) return ok;
    if (auto ok = writeAtomically(folder / "unmatched.csv", keyOf(images.unmatched)); !ok) return ok;
  } else if (auto ok = removeFormer(folder, {"unmatched", "unmatched.csv"}); !ok) {
    return ok;
  }
  if (auto ok = writeAtomically(folder / "features.csv", table(bench)); !ok) return ok;
  if (auto ok = writeAtomically(folder / "index.html", bench::realismPage(bench, images)); !ok) return ok;
  return writeAtomically(folder / "index.md", page(bench));
}

Result<BlindResult> scoreBlindTest(const fs::path& key, const std::vector<fs::path>& ratings) {
  const auto which = numbersIn(key, 0, 1, "0 or 1");
  if (!which) return tl::unexpected(which.error());
  BlindResult result;
  result.readers = int(ratings.size()), result.images = int(which->size());
  std::vector<ReaderRatings> readers;
  std::vector<std::map<int, NumberedLine>> all;
  for (const fs::path& file : ratings) {
    auto rated = numbersIn(file, 1, 6, "a rating from 1 to 6");
    if (!rated) return tl::unexpected(rated.error());
    ReaderRatings reader;
    double hits = 0, rejections = 0;
    for (const auto& [number, image] : *which) {
      const bool simulated = image.value == 1;
      const auto rating = rated->find(number);
      if (rating == rated->end())
        return fail(file.string() + " has no rating of image " + std::to_string(number) + ".");
      (simulated ? reader.positive : reader.negative).push_back(rating->second.value);
      if (simulated) hits += rating->second.value >= 4;
      if (!simulated) rejections += rating->second.value < 4;
    }
    for (const auto& [number, rating] : *rated)
      if (!which->contains(number))
        return fail(file.string() + " rates image " + std::to_string(number) + ", which the key does not list.");
    if (reader.positive.empty() || reader.negative.empty())
      return fail(key.string() + " lists images of one kind only.");
    result.sensitivity += hits / double(reader.positive.size()) / double(ratings.size());
    result.specificity += rejections / double(reader.negative.size()) / double(ratings.size());
    readers.push_back(std::move(reader));
    all.push_back(std::move(*rated));
  }
  result.separation = readersRocArea(readers);
  result.groups = groupResults(*which, all);
  return result;
}

}  // namespace insonate
