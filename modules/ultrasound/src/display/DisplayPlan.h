#pragma once

#include <insonate/ultrasound/BeamGrid.h>

#include <vector>

/// Constants of the display path. They are set so that simulated speckle meets the numbers measured on real images of
/// the neck: SD 11.5 gray levels at a mean near 60, skewness +0.28, grain 0.36 x 0.75 mm with a 7.5 MHz linear probe.
namespace insonate::display {

inline constexpr double kWhite_dB = 39.5;   ///< over unit speckle, at gain 0
inline constexpr double kMaxTgc_dB = 120;   ///< of the built-in compensation; more would only amplify nothing
inline constexpr double kHeadroom_dB = 15;  ///< levels kept below black and above white until smoothing is done

inline constexpr double kNoNoise_dB = -120;  ///< the lowest that can be set is none, and costs nothing

/// Haze: side lobes and reverberation leak a share of the echoes above into quiet regions.
inline constexpr double kHazeShare_dB = -10.5;
inline constexpr double kHazeTail_mm = 1.1;
inline constexpr double kHazeSpread_mm = 1.0;    ///< lateral SD gained over one tail
inline constexpr double kHazeSmoothShare = 0.6;  ///< the rest is modulated by the local speckle
inline constexpr double kHazeGrain = 0.3;        ///< share modulated by the speckle of each sample
inline constexpr double kHazeGrain_mm = 0.7;     ///< tail of the local mean that speckle is compared with
inline constexpr double kHazeCeiling_dB = 6;     ///< echoes above this leak no more than this
/// Haze behind strong reflectors, such that the shadow of bone has 0.33 to 0.52 of the gray of the tissue above.
inline constexpr double kHazeLongShare_dB = -30, kHazeLongTail_mm = 6;
inline constexpr double kHazeLongFrom_mm = 3;      ///< echoes above are the skin's and the face's
inline constexpr double kHazeLongCeiling_dB = 30;  ///< echoes above this leak no more than this
inline constexpr double kSideLobes_dB = -23;       ///< of the echoes beside
inline constexpr double kTwice_dB = -27;           ///< of the echoes of half the depth, on their second way
inline constexpr double kSmear_mm = 1.8;           ///< in which either falls to 1/e along the face
inline constexpr double kDriftReach_dB = 3, kDriftLateral_mm = 2.4, kDriftAxial_mm = 1.5;
inline constexpr double kRippleReach_dB = 2, kRippleLateral_mm = 1.8, kRippleAxial_mm = 0.45;  ///< finer, of repeats

/// Harmonic imaging: what comes back is weaker, so that the machine lifts noise with it (Averkiou, IEEE Ultrasonics
/// Symp 2000:1563: 10 to 20 dB below the fundamental); and haze is weaker still, since weak and early echoes have made
/// little of the harmonic (Duck, Ultrasound Med Biol 2002;28:1). The transmitted pulse itself is filtered out.
inline constexpr double kHarmonicLevel_dB = -12, kHarmonicHaze_dB = -8;

/// Share of the level, in dB, that an aperture smaller than the full one lacks and that the machine does not make up
/// for: chosen by the uppermost 4 mm of seven real neck images.
inline constexpr double kNearShare = 0.6, kFullAperture_mm = 8, kFewElements = 4;
/// Level of echoes in dB: those near the face reach few elements, whose aperture grows with the depth, and machines
/// make up for a part of it. 0 where the aperture is full.
double nearLevel_dB(const Probe& probe, double depth_mm);

/// Energy reflected at the top of a scanline does not reach the tissue below: bright places near the skin leave
/// streaks. And the outermost scanlines have half an aperture, the other half lying beyond the array's end.
inline constexpr double kShadeFrom_mm = 1.5, kShadeTo_mm = 7;  ///< where the bright places are looked for
inline constexpr double kShadeFull_mm = 12;                    ///< from where on the streaks have their full strength
inline constexpr double kStreakNarrow_mm = 0.8, kStreakWide_mm = 5;  ///< half widths compared: what stands out counts
inline constexpr double kStreakShare = 0.5, kStreakReach_dB = 4;  ///< dB lost per dB above the neighbourhood, at most
inline constexpr double kEdgeLoss_dB = 4.5, kEdgeWidth_mm = 5;    ///< at the ends of the array, and how far in

/// Smoothing of plain speckle, and along interfaces; widths in units of the point-spread function's FWHM.
inline constexpr double kPlainAxialSd = 0.44, kPlainLateralSd = 0.27;
inline constexpr double kAlongSd = 0.55;
/// Structure tensor in (dB per FWHM)^2, trace and difference of eigenvalues, from which a place counts as structure and
/// as an interface, and where it does so fully. In plain speckle the difference stays below 2 in 95 % of all places.
inline constexpr float kEdgeFrom = 2.5F, kEdgeTo = 12;
/// Slope from which interfaces are not followed, in units of FWHM axial per FWHM lateral.
inline constexpr float kMaxSlope = 3;
/// Contrast of speckle against its surroundings: d + d (kContrast + kContrastBend d), d within +-kContrastReach_dB.
inline constexpr float kContrast = 0.5F, kContrastBend = 0.2F, kContrastReach_dB = 6;

/// Edge enhancement at full strength: share of what a level stands out from those half a pulse above and below, and how
/// much of that counts.
inline constexpr double kEdgeShare = 0.8, kEdgeReach_dB = 10;

/// Values that change slowly with depth are kept per block of rows about as thick as the pulse.
struct Block {
  int first = 0, count = 0;              ///< rows
  int edgeStride = 1;                    ///< scanlines, half a point-spread function
  float edgeLateral = 1, edgeAxial = 1;  ///< differences to dB per FWHM
  int plainStride = 1;                   ///< scanlines between the 5 taps
  float plainWeight[3] = {};             ///< center, next, outermost
  int alongStride = 1;                   ///< scanlines between the 7 taps
  float alongWeight[4] = {};
  float rowsPerSlope = 0;  ///< rows per along-tap for an interface of slope 1 (FWHM per FWHM)
  int hazeStride = 1;      ///< scanlines to the neighbors that haze spreads from
  float hazeSpread = 0;    ///< share of each of them, per block
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
  int edgeRows;                                    ///< half a pulse
  float hazeDecay, hazeGrainDecay, hazeLongDecay;  ///< per block
  int longHazeFrom = 0;                            ///< first block that shines on behind strong reflectors
  std::vector<float> line_dB;                      ///< lateral gain of each scanline; empty where it is 0 throughout
  std::vector<float> edgeShade_dB;                 ///< [scanline]
  std::vector<float> shadeShare;                   ///< [row] of the shade of scanlines
  int shadeFirst = 0, shadeEnd = 0;                ///< blocks that cast streaks
  int streakNarrow, streakWide;                    ///< scanlines each side
  float low_dB, high_dB;                           ///< levels kept
  float black_dB, perLevel;                        ///< level share = (dB - black_dB) * perLevel

  void planShade(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid);

  /// Blocks whose centers lie around a row, and the share of the second.
  struct Between {
    int before, after;
    float mix;
  };
  Between between(int row) const;
};

}  // namespace insonate::display
