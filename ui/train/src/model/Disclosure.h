#pragma once

#include <insonate/curriculum/Curriculum.h>

#include <QObject>

namespace insonate::train {

class StatusLine;

/// Parts of the screen that disclose more than the ultrasound image and a real procedure do. A real procedure discloses
/// skin and tools from outside, the marks on the shaft, forces on the hand, the blood in the syringe, and the time.
/// Each widget that shows more asks DisclosureModel.
struct Disclosure {
  bool steps = true;     ///< disclosed: the steps to do now, and the attempt's metrics so far
  bool findings = true;  ///< disclosed: errors in the attempt
  /// disclosed: anatomy and the tissue at the needle's tip, i.e. CT, structures under the skin in 3D, areas of vessels
  /// and their curve, grid and pressure over the image, single effects of the model, named positions of the probe, the
  /// patient's pressures, the place of the tip and the name of the vessel that contains the tip.
  bool anatomy = true;
  /// disclosed: images of other places than the present one. Before a test begins, mouse and keys do not move the
  /// probe, so that the case cannot be scanned ahead of the clock.
  bool otherPlaces = true;

  bool operator==(const Disclosure&) const = default;
};

/// Returns the disclosure for this assistance; outside an attempt everything is disclosed.
Disclosure disclosureOf(Assistance assistance, bool inAttempt);

/// The disclosure that applies now, and its changes.
class DisclosureModel : public QObject {
  Q_OBJECT

 public:
  explicit DisclosureModel(StatusLine& status, QObject* parent = nullptr);

  const Disclosure& current() const { return current_; }
  void set(const Disclosure& disclosure);
  /// Tells whether anatomy is disclosed; if not, shows the user a message.
  bool mayShowAnatomy();

 Q_SIGNALS:
  void changed();

 private:
  StatusLine& status_;
  Disclosure current_;
};

}  // namespace insonate::train
