#pragma once

#include <insonate/ultrasound/BeamGrid.h>

#include <vector>

/// Constants of the display path. They are chosen so that simulated speckle has the properties measured on real images
/// of the neck: SD of 11.5 gray levels at a mean near 60, skewness +0.28, speckle size 0.36 x 0.75 mm with a 7.5 MHz
/// linear probe.
namespace insonate::display {

inline constexpr double kWhite_dB = 39.5;  ///< level displayed as white at gain 0; 0 dB is the speckle of a 0 dB tissue
/// Maximum of the built-in time-gain compensation; more would amplify only noise.
inline constexpr double kMaxTgc_dB = 120;
/// Range of levels below black and above white that smoothing still distinguishes.
inline constexpr double kHeadroom_dB = 15;

/// Minimum of ImagingSettings::noise_dB: stands for no noise, and has no cost.
inline constexpr double kNoNoise_dB = -120;

/// Haze: weak echoes that side lobes and reverberation add to dark regions. This is the level of the haze relative to
/// the echoes at smaller depth that cause the haze.
inline constexpr double kHazeShare_dB = -10.5;
inline constexpr double kHazeTail_mm = 1.1;
/// Lateral SD by which haze spreads while it falls to 1/e along the depth (kHazeTail_mm).
inline constexpr double kHazeSpread_mm = 1.0;
inline constexpr double kHazeSmoothShare = 0.6;  ///< share of the haze that is not modulated by the local speckle
inline constexpr double kHazeGrain = 0.3;        ///< share of the haze that is modulated by the speckle of each sample
/// Axial length of the local mean with which the speckle of a sample is compared.
inline constexpr double kHazeGrain_mm = 0.7;
inline constexpr double kHazeCeiling_dB = 6;  ///< level of an echo above which the haze behind it does not grow
/// Haze behind strong reflectors such as bone: level of the haze relative to the reflector, and depth over which the
/// haze falls to 1/e. The values were chosen so that the shadow of bone has 0.33 to 0.52 of the gray of the tissue
/// above.
inline constexpr double kHazeLongShare_dB = -30, kHazeLongTail_mm = 6;
/// Minimum depth of strong reflectors with haze behind them; shallower echoes are from the skin and the face.
inline constexpr double kHazeLongFrom_mm = 3;
/// Level of a reflector above which the haze behind it does not grow.
inline constexpr double kHazeLongCeiling_dB = 30;
/// Haze by side lobes: level relative to the echoes beside a scanline at the same depth.
inline constexpr double kSideLobes_dB = -23;
/// Haze by a second round trip between face and tissue: level relative to the echoes at half the depth.
inline constexpr double kTwice_dB = -27;
/// Lateral distance over which the haze by side lobes and second round trips falls to 1/e.
inline constexpr double kSmear_mm = 1.8;
inline constexpr double kDriftReach_dB = 3, kDriftLateral_mm = 2.4, kDriftAxial_mm = 1.5;
/// Fine random variation of the haze from place to place: amplitude, lateral and axial size. The kDrift constants
/// describe the coarse variation.
inline constexpr double kRippleReach_dB = 2, kRippleLateral_mm = 1.8, kRippleAxial_mm = 0.45;

/// Change of levels in harmonic imaging. Received echoes are weaker (Averkiou, IEEE Ultrasonics Symp 2000:1563: 10 to
/// 20 dB below the fundamental), and the machine amplifies noise together with them. Haze is weaker still, since weak
/// and early echoes contain little of the harmonic (Duck, Ultrasound Med Biol 2002;28:1). The transmitted pulse itself
/// is filtered out.
inline constexpr double kHarmonicLevel_dB = -12, kHarmonicHaze_dB = -8;

/// Near the face the active aperture is small and receives weaker echoes. kNearShare: share of this loss, in dB, that
/// the machine does not compensate, fitted to the uppermost 4 mm of seven real neck images. kFullAperture_mm: aperture
/// without loss. kFewElements: elements of the smallest aperture.
inline constexpr double kNearShare = 0.6, kFullAperture_mm = 8, kFewElements = 4;
/// Returns the change of the echo level near the face, in dB: few elements receive there, since the aperture grows with
/// depth, and machines compensate only a part of this loss. 0 where the aperture is full.
double nearLevel_dB(const Probe& probe, double depth_mm);

/// Streaks: energy reflected at the top of a scanline does not reach the tissue below, so that bright places near the
/// skin leave dark streaks below.
/// Depths between which bright places near the skin are searched.
inline constexpr double kShadeFrom_mm = 1.5, kShadeTo_mm = 7;
/// Depth from which on the dark streaks below bright places have full strength.
inline constexpr double kShadeFull_mm = 12;
/// Half widths of the narrow and the wide lateral mean whose comparison finds places brighter than their neighborhood.
inline constexpr double kStreakNarrow_mm = 0.8, kStreakWide_mm = 5;
/// Darkness of the streak below a bright place: dB lost per dB above the neighborhood, and maximum loss.
inline constexpr double kStreakShare = 0.5, kStreakReach_dB = 4;
/// Loss at the ends of the array, where half the aperture is missing, and width of the affected strip.
inline constexpr double kEdgeLoss_dB = 4.5, kEdgeWidth_mm = 5;

/// SD of the smoothing of plain speckle, axial and lateral, in units of the point-spread function's FWHM. kAlongSd: the
/// same along interfaces.
inline constexpr double kPlainAxialSd = 0.44, kPlainLateralSd = 0.27;
inline constexpr double kAlongSd = 0.55;
/// Thresholds for the difference of the structure tensor's eigenvalues, in (dB per FWHM)^2, which decides whether a
/// place is an interface: below kEdgeFrom no interface, from kEdgeTo on a full interface. The trace decides whether the
/// place is structure at all. In plain speckle the difference is below 2 at 95 % of all places.
inline constexpr float kEdgeFrom = 2.5F, kEdgeTo = 12;
/// Slope above which an interface is not smoothed along itself, in units of axial FWHM per lateral FWHM.
inline constexpr float kMaxSlope = 3;
/// Enhancement of the contrast of speckle against its surroundings: a difference d becomes d + d (kContrast +
/// kContrastBend d), with d limited to +-kContrastReach_dB.
inline constexpr float kContrast = 0.5F, kContrastBend = 0.2F, kContrastReach_dB = 6;

/// Edge enhancement at full strength: a level changes by kEdgeShare times its difference from the levels half a pulse
/// above and below; at most kEdgeReach_dB of the difference counts.
inline constexpr double kEdgeShare = 0.8, kEdgeReach_dB = 10;

/// A block of sample rows about as thick as the pulse, for values that change slowly with depth.
struct Block {
  int first = 0, count = 0;              ///< first row of the block, and number of its rows
  int edgeStride = 1;                    ///< half the width of the point-spread function, in scanlines
  float edgeLateral = 1, edgeAxial = 1;  ///< factors that convert level differences to dB per FWHM, lateral and axial
  int plainStride = 1;                   ///< scanlines between the 5 lateral taps of the smoothing of plain speckle
  float plainWeight[3] = {};             ///< weights of the 5 lateral taps: center, next, outermost
  int alongStride = 1;                   ///< scanlines between the 7 taps of the smoothing along interfaces
  float alongWeight[4] = {};
  float rowsPerSlope = 0;  ///< rows per tap along an interface of slope 1 (FWHM per FWHM)
  int hazeStride = 1;      ///< distance in scanlines to the neighbors from which haze spreads
  float hazeSpread = 0;    ///< share of each neighbor's haze that spreads, per block of depth
};

/// All constants of the display path that depend only on probe and settings.
struct DisplayPlan {
  DisplayPlan(const Probe& probe, const ImagingSettings& settings);

  int scanlines, samples;
  int blockRows;
  std::vector<Block> blocks;
  std::vector<float> rowGain;       ///< built-in time-gain compensation of each row of samples, as a factor
  std::vector<float> rowOffset_dB;  ///< gain and TGC sliders of each row of samples
  int axialStride;                  ///< rows between the 5 axial taps of the smoothing of plain speckle
  float axialWeight[3];
  int edgeRows;  ///< half the pulse's length, in rows
  /// Factors by which the tails of the haze fall from one block of rows to the next.
  float hazeDecay, hazeGrainDecay, hazeLongDecay;
  int longHazeFrom = 0;              ///< first block of rows in which strong reflectors cause haze behind them
  std::vector<float> line_dB;        ///< lateral gain of each scanline; empty if it is 0 everywhere
  std::vector<float> edgeShade_dB;   ///< [scanline] loss at the ends of the array
  std::vector<float> shadeShare;     ///< [row] share of each scanline's streak loss that applies to the row
  int shadeFirst = 0, shadeEnd = 0;  ///< first and end of the blocks of rows whose bright places cast dark streaks
  int streakNarrow, streakWide;      ///< half widths, in scanlines, of the two means by which bright places are found
  float low_dB, high_dB;             ///< minimum and maximum level that the display distinguishes
  /// A level's position in the dynamic range, 0 to 1, is (level in dB - black_dB) * perLevel.
  float black_dB, perLevel;

  void planShade(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid);

  /// The two blocks of rows whose centers enclose a row, and the weight of the second block.
  struct Between {
    int before, after;
    float mix;
  };
  Between between(int row) const;
};

}  // namespace insonate::display
