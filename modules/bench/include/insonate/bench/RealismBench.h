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

/// A real or simulated ultrasound image for comparison: the inside of the field of view, without text, at
/// kLookPixelsPer_mm and at most 30 mm deep.
struct SourceImage {
  std::string source;  ///< origin. Real image: machine or data set; simulated image: neck
  std::string about;   ///< description. Real image: file; simulated image: neck, view and settings
  GreyPicture image;
};

/// Reads real images from a text file with lines `file,pixels per mm,source`. If a file shows more than the inside of
/// the field of view, the line also has `,left,top,width,height` of the inside in pixels. # begins a comment; paths are
/// relative to the text file. Fails, naming the line, on an image that cannot be read or measured, and on a list
/// without images.
Result<std::vector<SourceImage>> readRealImages(const std::filesystem::path& list);

/// Number, random seed and cases of the images to simulate.
struct SimulatedSet {
  int count = 20;
  unsigned seed = 1;  ///< random seed; another seed gives other necks, views and settings
  /// Folders of cases (CTs of patients, atlases) used in addition to the built-in necks.
  std::vector<std::filesystem::path> cases;
};

/// Simulates images of built-in necks and the given cases, in turn two images of each. Each image has another view,
/// place and compression, and is made with one of machines(). Depth, frequency, gain, dynamic range, gray map and
/// contact of the probe's ends are drawn at random, with about the variation of real sources. Each image is cropped to
/// the size of an image of `real`, in turn. The same set gives the same images. Takes a few seconds per image. Fails on
/// a case that cannot be read or has no skin.
Result<std::vector<SourceImage>> simulatedImages(const SimulatedSet& set, const std::vector<SourceImage>& real,
                                                 const Progress& progress = {});

/// Comparison of one image feature between real and simulated images.
struct RealismFeature {
  std::string name;
  double real = 0, realLow = 0, realHigh = 0;  ///< values in real images: median, 10th and 90th percentile
  /// values in simulated images: median, 10th and 90th percentile
  double simulated = 0, simulatedLow = 0, simulatedHigh = 0;
  RocArea told;  ///< ROC area with which the feature separates simulated (greater values) from real images
  /// ROC area, 0.5 to 1, with which the feature separates one real source (machine or data set) from the others: median
  /// over sources with at least 4 images. NaN without two such sources.
  double floor = 0;
  /// p-value of the difference between real and simulated images, corrected for the number of features (Holm, Scand J
  /// Stat 1979, 6:65).
  double p = 1;
  /// Tells whether the feature separates simulated from real images better than real sources from each other (`floor`),
  /// with p below 0.05.
  bool isBeyondFloor() const;
};

struct RealismBench {
  std::vector<SourceImage> real, simulated;
  std::vector<RealismFeature> features;  ///< comparison of each feature, the most discriminating first
  RocArea classifier;  ///< ROC area of a linear classifier of simulated against real images, cross-validated by leaving
                       ///< out one source at a time
  unsigned seed = 1;
};

Result<RealismBench> runRealismBench(std::vector<SourceImage> real, const SimulatedSet& set,
                                     const Progress& progress = {});

/// Writes the results (features.csv, index.md) and the images for a blind test into `folder`; either all of it or
/// nothing. `blind/` holds all images in random order, numbered, of one size in mm and with the same compression, with
/// instructions, a sheet to look at (sheet.html, sheet-N.png) and a sheet to fill in (ratings.csv). key.csv, outside
/// `blind/`, tells which images are real.
Result<void> writeRealismBench(const RealismBench& bench, const std::filesystem::path& folder);

/// Result of a blind test in which readers rated whether images are real or simulated.
struct BlindResult {
  int readers = 0, images = 0;
  double sensitivity = 0, specificity = 0;  ///< means over readers; an image rated 4 or more counts as judged simulated
  RocArea told;
};

/// Evaluates a blind test: compares the readers' ratings with key.csv, which tells the real images. Each reader's
/// ratings.csv has lines `number,rating` with ratings 1 (real) to 6 (simulated). Fails, with file and line, on a rating
/// that is missing, repeated or not a number from 1 to 6.
Result<BlindResult> scoreBlindTest(const std::filesystem::path& key, const std::vector<std::filesystem::path>& ratings);

nlohmann::json toJson(const RealismBench& bench);
nlohmann::json toJson(const BlindResult& result);

}  // namespace insonate
