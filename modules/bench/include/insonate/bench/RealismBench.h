#pragma once

#include <insonate/bench/RocArea.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/ultrasound/FovFit.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// An image of the inside of a field of view, without text, at kLookPixelsPer_mm, at most 30 mm deep.
struct SourceImage {
  std::string source;  ///< of a real one: machine or data set; of a simulated one: its neck
  std::string about;   ///< file, or neck, view and settings
  GreyPicture image;
};

/// Images listed as lines `file,pixels per mm,source`, with `,left,top,width,height` of the inside of the field of view
/// in pixels where a file shows more (# begins a comment; a file's path is relative to the list).
/// Fails, naming the line, on a file that cannot be read or measured, and on a list without images.
Result<std::vector<SourceImage>> readRealImages(const std::filesystem::path& list);

/// Images to simulate.
struct SimulatedSet {
  int count = 20;
  unsigned seed = 1;                         ///< other necks, views and settings
  std::vector<std::filesystem::path> cases;  ///< case folders beside the built-in necks: CTs of patients, atlases
};

/// Images of built-in necks and the given cases, two of each in turn, each with another view, place and
/// compression, on one of machines(), with depth, frequency, gain, dynamic range, gray map and contact of the probe's
/// ends drawn at random, about as far apart as those of real sources. Each is cut to the size of one of `real`, in
/// turn. The same set gives the same images. A few seconds each. Fails on a case that cannot be read or has no skin.
Result<std::vector<SourceImage>> simulatedImages(const SimulatedSet& set, const std::vector<SourceImage>& real,
                                                 const Progress& progress = {});

/// A feature of both sets.
struct RealismFeature {
  std::string name;
  double real = 0, realLow = 0, realHigh = 0;                 ///< median, 10th and 90th percentile
  double simulated = 0, simulatedLow = 0, simulatedHigh = 0;  ///< the same
  RocArea told;                                               ///< apart, greater values counting as simulated
  double floor = 0;  ///< median over real sources of 4 images or more: how far from 0.5 the area lies by which each is
                     ///< told from the other sources; NaN without two such sources
  double p = 1;      ///< that both sets are alike, corrected for the number of features (Holm, Scand J Stat 1979, 6:65)
  bool isBeyondFloor() const;  ///< told better than real sources are told from each other, with p below 0.05
};

struct RealismBench {
  std::vector<SourceImage> real, simulated;
  std::vector<RealismFeature> features;  ///< the most telling first
  RocArea classifier;                    ///< cross-validated by leaving out one source at a time
  unsigned seed = 1;
};

Result<RealismBench> runRealismBench(std::vector<SourceImage> real, const SimulatedSet& set,
                                     const Progress& progress = {});

/// features.csv, index.md, and the blind test: `blind/` holds all images, shuffled, numbered, of one size in mm and
/// compressed alike, with instructions, a sheet to look at (sheet.html, sheet-N.png) and one to fill in
/// (ratings.csv); key.csv, outside of it, says which is which. All of it or nothing.
Result<void> writeRealismBench(const RealismBench& bench, const std::filesystem::path& folder);

/// Result of the readers of a blind test.
struct BlindResult {
  int readers = 0, images = 0;
  double sensitivity = 0, specificity = 0;  ///< mean over readers; ratings of 4 and more count as simulated
  RocArea told;
};

/// Ratings (number,1 to 6 in ratings.csv as readers filled it in, one file each) against key.csv. Fails, naming file
/// and line, on a rating that is missing, doubled or no number from 1 to 6.
Result<BlindResult> scoreBlindTest(const std::filesystem::path& key, const std::vector<std::filesystem::path>& ratings);

nlohmann::json toJson(const RealismBench& bench);
nlohmann::json toJson(const BlindResult& result);

}  // namespace insonate
