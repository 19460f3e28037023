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

/// An image of the inside of a field of view, without text, at kLookPixelsPer_mm and at most 30 mm deep.
struct SourceImage {
  std::string source;  ///< real image: machine or data set; simulated image: neck
  std::string about;   ///< file, or neck, view and settings
  GreyPicture image;
};

/// Reads the images of a list with lines `file,pixels per mm,source`. If a file shows more than the inside of the field
/// of view, the line also has `,left,top,width,height` of the inside in pixels. # begins a comment; a file's path is
/// relative to the list. Fails, with the line, on a file that cannot be read or measured, and on a list without images.
Result<std::vector<SourceImage>> readRealImages(const std::filesystem::path& list);

/// Set of images to simulate.
struct SimulatedSet {
  int count = 20;
  unsigned seed = 1;  ///< another seed gives other necks, views and settings
  /// Case folders used in addition to the built-in necks: CTs of patients, atlases.
  std::vector<std::filesystem::path> cases;
};

/// Simulates images of built-in necks and the given cases, in turn two images of each. Each image has another view,
/// place and compression, and is made with one of machines(). Depth, frequency, gain, dynamic range, gray map and
/// contact of the probe's ends are drawn at random, with about the variation of real sources. Each image is cropped to
/// the size of an image of `real`, in turn. The same set gives the same images. Takes a few seconds per image. Fails on
/// a case that cannot be read or has no skin.
Result<std::vector<SourceImage>> simulatedImages(const SimulatedSet& set, const std::vector<SourceImage>& real,
                                                 const Progress& progress = {});

/// Comparison of one feature between both sets.
struct RealismFeature {
  std::string name;
  double real = 0, realLow = 0, realHigh = 0;                 ///< median, 10th and 90th percentile
  double simulated = 0, simulatedLow = 0, simulatedHigh = 0;  ///< likewise for simulated images
  RocArea told;      ///< separation of the sets by this feature; greater values count as simulated
  double floor = 0;  ///< ROC area, 0.5 to 1, by which real sources differ: median over real sources with at least 4
                     ///< images of the area that separates the source from all others; NaN without two such sources
  double p = 1;  ///< probability of such a difference between equal sets, corrected for the number of features (Holm,
                 ///< Scand J Stat 1979, 6:65)
  /// The sets are told apart better than real sources are told from each other, with p below 0.05.
  bool isBeyondFloor() const;
};

struct RealismBench {
  std::vector<SourceImage> real, simulated;
  std::vector<RealismFeature> features;  ///< the most discriminating feature first
  RocArea classifier;                    ///< cross-validated by leaving out one source at a time
  unsigned seed = 1;
};

Result<RealismBench> runRealismBench(std::vector<SourceImage> real, const SimulatedSet& set,
                                     const Progress& progress = {});

/// Writes features.csv, index.md and the blind test; either all of it or nothing. `blind/` holds all images in random
/// order, numbered, of one size in mm and with the same compression, with instructions, a sheet to look at (sheet.html,
/// sheet-N.png) and a sheet to fill in (ratings.csv). key.csv, outside `blind/`, tells which images are real.
Result<void> writeRealismBench(const RealismBench& bench, const std::filesystem::path& folder);

/// Result of a blind test by several readers.
struct BlindResult {
  int readers = 0, images = 0;
  double sensitivity = 0, specificity = 0;  ///< means over readers; ratings of 4 and more count as simulated
  RocArea told;
};

/// Scores ratings against key.csv. Each reader's ratings.csv has lines `number,rating` with ratings 1 to 6. Fails, with
/// file and line, on a rating that is missing, repeated or not a number from 1 to 6.
Result<BlindResult> scoreBlindTest(const std::filesystem::path& key, const std::vector<std::filesystem::path>& ratings);

nlohmann::json toJson(const RealismBench& bench);
nlohmann::json toJson(const BlindResult& result);

}  // namespace insonate
