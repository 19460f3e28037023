#pragma once

#include <insonate/ultrasound/BeamGrid.h>

#include <vector>

/// Constants of the display path. They are chosen so that simulated speckle has the properties measured on real images
/// of the neck: SD of 11.5 gray levels at a mean near 60, skewness +0.28, speckle size 0.36 x 0.75 mm with a 7.5 MHz
/// linear probe.
namespace insonate::display {

inline constexpr double kWhite_dB = 39.5;  ///< white level, relative to unit speckle, at gain 0
inline constexpr double kMaxTgc_dB = 120;  ///< maximum of the built-in compensation; more would amplify only noise
/// Range of levels kept below black and above white until smoothing is done.
inline constexpr double kHeadroom_dB = 15;

inline constexpr double kNoNoise_dB = -120;  ///< minimum of the setting; means no noise, and has no cost

/// Haze: side lobes and reverberation leak a share of the echoes above into weakly echoing regions.
inline constexpr double kHazeShare_dB = -10.5;
inline constexpr double kHazeTail_mm = 1.1;
inline constexpr double kHazeSpread_mm = 1.0;    ///< lateral SD gained over one tail
inline constexpr double kHazeSmoothShare = 0.6;  ///< share that is not modulated by the local speckle
inline constexpr double kHazeGrain = 0.3;        ///< share modulated by the speckle of each sample
inline constexpr double kHazeGrain_mm = 0.7;     ///< length of the local mean with which the speckle is compared
inline constexpr double kHazeCeiling_dB = 6;     ///< stronger echoes leak no more than this level
/// Haze behind strong reflectors, chosen so that the shadow of bone has 0.33 to 0.52 of the gray of the tissue above.
inline constexpr double kHazeLongShare_dB = -30, kHazeLongTail_mm = 6;
inline constexpr double kHazeLongFrom_mm = 3;      ///< shallower echoes are from the skin and the face
inline constexpr double kHazeLongCeiling_dB = 30;  ///< stronger echoes leak no more than this level
inline constexpr double kSideLobes_dB = -23;       ///< relative to the lateral echoes at the same depth
/// Relative to the echoes at half the depth, which arrive after a second round trip.
inline constexpr double kTwice_dB = -27;
/// Distance along the face over which side lobes and second echoes fall to 1/e.
inline constexpr double kSmear_mm = 1.8;
inline constexpr double kDriftReach_dB = 3, kDriftLateral_mm = 2.4, kDriftAxial_mm = 1.5;
/// Finer variation, for repeated echoes.
inline constexpr double kRippleReach_dB = 2, kRippleLateral_mm = 1.8, kRippleAxial_mm = 0.45;

/// Harmonic imaging: received echoes are weaker (Averkiou, IEEE Ultrasonics Symp 2000:1563: 10 to 20 dB below the
/// fundamental), and the machine amplifies noise together with them. Haze is weaker still, since weak and early echoes
/// contain little of the harmonic (Duck, Ultrasound Med Biol 2002;28:1). The transmitted pulse itself is filtered out.
inline constexpr double kHarmonicLevel_dB = -12, kHarmonicHaze_dB = -8;

/// Share, in dB, of the level missing in a small aperture that the machine does not compensate. It was fitted to the
/// uppermost 4 mm of seven real neck images.
inline constexpr double kNearShare = 0.6, kFullAperture_mm = 8, kFewElements = 4;
/// Level of echoes in dB. Echoes near the face reach few elements, since the aperture grows with depth; machines
/// compensate a part of this loss. 0 if the aperture is full.
double nearLevel_dB(const Probe& probe, double depth_mm);

/// Energy reflected at the top of a scanline does not reach the tissue below: bright places near the skin leave
/// streaks. And the outermost scanlines have half an aperture, the other half lying beyond the array's end.
inline constexpr double kShadeFrom_mm = 1.5, kShadeTo_mm = 7;  ///< depths in which bright places are searched
inline constexpr double kShadeFull_mm = 12;                    ///< depth from which the streaks have full strength
/// Half widths of the two means that are compared: bright places exceed the wide mean.
inline constexpr double kStreakNarrow_mm = 0.8, kStreakWide_mm = 5;
/// dB lost per dB above the neighborhood, and maximum loss.
inline constexpr double kStreakShare = 0.5, kStreakReach_dB = 4;
/// Loss at the ends of the array, and width of the affected strip.
inline constexpr double kEdgeLoss_dB = 4.5, kEdgeWidth_mm = 5;

/// Smoothing of plain speckle and along interfaces; widths in units of the point-spread function's FWHM.
inline constexpr double kPlainAxialSd = 0.44, kPlainLateralSd = 0.27;
inline constexpr double kAlongSd = 0.55;
/// Thresholds for the structure tensor in (dB per FWHM)^2. The trace decides whether a place is structure, the
/// difference of the eigenvalues whether it is an interface: not below kEdgeFrom, fully from kEdgeTo on. In plain
/// speckle the difference is below 2 at 95 % of all places.
inline constexpr float kEdgeFrom = 2.5F, kEdgeTo = 12;
/// Slope above which interfaces are not followed, in units of axial FWHM per lateral FWHM.
inline constexpr float kMaxSlope = 3;
/// Contrast of speckle relative to its surroundings: a difference d becomes d + d (kContrast + kContrastBend d), with d
/// limited to +-kContrastReach_dB.
inline constexpr float kContrast = 0.5F, kContrastBend = 0.2F, kContrastReach_dB = 6;

/// Edge enhancement at full strength: share of the difference of a level from the levels half a pulse above and below,
/// and maximum of the difference that counts.
inline constexpr double kEdgeShare = 0.8, kEdgeReach_dB = 10;

/// Block of rows about as thick as the pulse, for values that change slowly with depth.
struct Block {
  int first = 0, count = 0;              ///< rows
  int edgeStride = 1;                    ///< half a point-spread function, in scanlines
  float edgeLateral = 1, edgeAxial = 1;  ///< factors from differences to dB per FWHM
  int plainStride = 1;                   ///< scanlines between the 5 taps
  float plainWeight[3] = {};             ///< center, next, outermost
  int alongStride = 1;                   ///< scanlines between the 7 taps
  float alongWeight[4] = {};
  float rowsPerSlope = 0;  ///< rows per tap along an interface of slope 1 (FWHM per FWHM)
  int hazeStride = 1;      ///< distance in scanlines to the neighbors from which haze spreads
  float hazeSpread = 0;    ///< share of each neighbor, per block
};

/// Everything that follows from probe and settings alone.
struct DisplayPlan {
  DisplayPlan(const Probe& probe, const ImagingSettings& settings);

  int scanlines, samples;
  int blockRows;
  std::vector<Block> blocks;
  std::vector<float> rowGain;       ///< built-in compensation, linear
  std::vector<float> rowOffset_dB;  ///< gain and sliders
  int axialStride;                  ///< rows between the 5 taps of plain smoothing
  float axialWeight[3];
  int edgeRows;                                    ///< half a pulse, in rows
  float hazeDecay, hazeGrainDecay, hazeLongDecay;  ///< per block
  int longHazeFrom = 0;                            ///< first block that leaks haze behind strong reflectors
  std::vector<float> line_dB;                      ///< lateral gain of each scanline; empty if it is 0 everywhere
  std::vector<float> edgeShade_dB;                 ///< [scanline]
  std::vector<float> shadeShare;                   ///< [row] share of the scanlines' shade
  int shadeFirst = 0, shadeEnd = 0;                ///< blocks that cast streaks
  int streakNarrow, streakWide;                    ///< scanlines each side
  float low_dB, high_dB;                           ///< limits of the levels that are kept
  float black_dB, perLevel;                        ///< level share = (dB - black_dB) * perLevel

  void planShade(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid);

  /// The two blocks whose centers enclose a row, and the weight of the second.
  struct Between {
    int before, after;
    float mix;
  };
  Between between(int row) const;
};

}  // namespace insonate::display
