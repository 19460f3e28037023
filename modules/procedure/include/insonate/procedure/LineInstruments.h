#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace insonate {

/// Instruments of the Seldinger technique that enter the body. The numbers are stored in recordings and must not
/// change.
enum class Instrument : std::uint8_t { Needle = 0, Wire = 1, Dilator = 2, Catheter = 3 };
inline constexpr int kInstruments = 4;

/// Acts of the trainee before the puncture and with the instruments of the line. The numbers are stored in recordings
/// and must not change.
enum class LineAct : std::uint8_t {
  CheckConsent = 0,      ///< indication, contraindications and consent were checked
  TimeOut = 1,           ///< patient, side and site were confirmed by the team
  CoverProbe = 2,        ///< sterile cover and gel on the probe, drape on the patient
  Anesthetize = 3,       ///< local anesthetic at the site of the puncture
  DetachSyringe = 4,     ///< the syringe was taken off the needle's hub
  AttachSyringe = 5,     ///< a syringe was put on the needle's hub
  CoverHub = 6,          ///< a finger closes the needle's hub
  UncoverHub = 7,        ///< the finger was taken off the hub
  HoldWire = 8,          ///< the hand holds the wire outside the body
  ReleaseWire = 9,       ///< the hand let go of the wire
  NickSkin = 10,         ///< a scalpel enlarged the hole in the skin beside the wire
  MeasurePressure = 11,  ///< the pressure at the hub was measured by column or transducer (AttemptEvent::amount, mmHg)
  FlushForBubbles =
      12,  ///< agitated saline was injected; AttemptEventKind::BubblesSeen follows if its bubbles are seen
  TrustBloodColor = 13,   ///< the color of the blood was taken as proof of the vein
  AspirateLumen = 14,     ///< blood was aspirated from a lumen of the catheter (AttemptEvent::amount: its number)
  FlushLumen = 15,        ///< a lumen was flushed with saline and clamped (AttemptEvent::amount: its number)
  SecureCatheter = 16,    ///< the catheter was sutured or fixed by a holder
  ApplyDressing = 17,     ///< a sterile dressing covers the site
  CheckLungSliding = 18,  ///< the pleura of this side was looked at after the procedure (AttemptEvent::amount: 1 if
                          ///< the lung did not slide)
};
inline constexpr int kLineActs = 19;
inline constexpr int kCatheterLumens = 3;

/// Returns the name of an act in files and scripts: "detach syringe".
std::string_view nameOf(LineAct act);
/// Returns the names of all acts, in their order.
const std::array<std::string_view, kLineActs>& lineActNames();
/// Returns the names of all instruments, in their order.
const std::array<std::string_view, kInstruments>& instrumentNames();
/// Returns "needle", "wire", "dilator" or "catheter".
std::string_view nameOf(Instrument instrument);

}  // namespace insonate
