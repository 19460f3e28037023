#pragma once

#include <insonate/bench/RocArea.h>
#include <insonate/bench/SourceImage.h>
#include <insonate/core/Progress.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Set of images to simulate.
struct SimulatedSet {
  int count = 20;
  unsigned seed = 1;  ///< another seed gives other necks, views and settings
  /// Case folders used in addition to the built-in necks: CTs of patients, atlases.
  std::vector<std::filesystem::path> cases = {};
  /// Probes and planes, used in turn. If a list is empty, the probes or planes of the real images are used in turn; any
  /// plane for a real image whose plane is not stated.
  std::vector<ProbeShape> probes = {};
  std::vector<ScanPlane> planes = {};
  bool clips = false;  ///< true: only clips are simulated; false: clips for real clips and stills for real stills
};

/// Simulates images of the built-in necks and the given cases, in turn. Each image has a different view, place and
/// compression, and is made with one of machines(). Depth, frequency, gain, dynamic range, gray map and contact of the
/// probe's ends are drawn at random, with about the variation of real sources. Each image of a linear probe is cropped
/// to the size of one of the images of a linear probe in `real`, which are used in turn. In a clip the vessels pulsate;
/// in every second clip the probe also slides and tilts slowly. The same set gives the same images. Takes a few seconds
/// per image, and about ten per clip. Fails on a case that cannot be read or has no skin.
Result<std::vector<SourceImage>> simulatedImages(const SimulatedSet& set, const std::vector<SourceImage>& real,
                                                 const Progress& progress = {});

/// Comparison of one image feature between real and simulated images.
struct RealismFeature {
  std::string name;
  double real = 0, realLow = 0, realHigh = 0;                 ///< real images: median, 10th and 90th percentile
  double simulated = 0, simulatedLow = 0, simulatedHigh = 0;  ///< simulated images: median, 10th and 90th percentile
  RocArea separation;  ///< ROC area by which this feature separates the two sets; larger values count as simulated
  /// ROC area, 0.5 to 1, that separates the real images of one source from those of all other sources: median over the
  /// sources with at least 4 images; NaN if there are fewer than two such sources
  double floor = 0;
  /// probability of a separation at least as large if real and simulated images do not differ, corrected for the number
  /// of features of all comparisons (Holm, Scand J Stat 1979, 6:65)
  double p = 1;
  /// Tells whether the feature separates simulated from real images better than the feature separates real sources from
  /// each other, with p below 0.05.
  bool exceedsFloor() const;
};

/// Comparison of real and simulated images of one probe shape.
struct RealismComparison {
  ProbeShape probe = ProbeShape::Linear;
  int real = 0, simulated = 0;           ///< numbers of images
  std::vector<RealismFeature> features;  ///< the most discriminating feature first
  /// ROC area of a classifier that uses all features; cross-validated by leaving out one source at a time
  RocArea classifier;
};

struct RealismBench {
  std::vector<SourceImage> real, simulated;
  std::vector<RealismComparison> comparisons;
  unsigned seed = 1;
};

Result<RealismBench> runRealismBench(std::vector<SourceImage> real, const SimulatedSet& set,
                                     const Progress& progress = {});

/// Writes features.csv, index.md, index.html and a blind test; either all of it or nothing. The folder `blind/`
/// contains the blind test:
/// - images and clips, numbered in random order, with one scale and the same file compression
/// - the page on which readers rate the images (sheet.html), and a list for ratings by hand (ratings.csv)
/// - sheets of images (sheet-N.png), and instructions
/// key.csv, outside `blind/`, states which images are real. Images of a kind (probe, still or clip) that only one of
/// the sets contains could be recognized by their kind. These images are written to `unmatched/` instead, and
/// unmatched.csv lists them.
Result<void> writeRealismBench(const RealismBench& bench, const std::filesystem::path& folder);

/// Result for the images of one kind.
struct BlindGroup {
  std::string name;             ///< name of the compared subset of images, e.g. "linear", "transverse", "clips"
  int real = 0, simulated = 0;  ///< numbers of images
  RocArea separation;
};

/// Result of a blind test by several readers.
struct BlindResult {
  int readers = 0, images = 0;
  /// means over readers; a rating of 4 or more means that the reader judged the image to be simulated
  double sensitivity = 0, specificity = 0;
  RocArea separation;
  /// results by probe, by plane, and by still or clip, if the set has several of them
  std::vector<BlindGroup> groups;
};

/// Scores ratings against key.csv. Each reader's ratings.csv has lines `number,rating` with ratings 1 to 6; further
/// cells are ignored. Fails, with file and line, on a rating that is missing, repeated or not a number from 1 to 6.
Result<BlindResult> scoreBlindTest(const std::filesystem::path& key, const std::vector<std::filesystem::path>& ratings);

nlohmann::json toJson(const RealismBench& bench);
nlohmann::json toJson(const BlindResult& result);

}  // namespace insonate
