#pragma once

#include <insonate/train/LiveRates.h>
#include <insonate/ui/Workspace.h>

#include <filesystem>
#include <functional>
#include <memory>

namespace insonate::train {

/// The room where a probe is moved over a patient and the ultrasound image follows. Controls on the left, the image
/// in the middle, the patient in 3D and as CT on the right. The hand is the mouse and the keyboard; shortcuts() lists
/// what they do. Computing happens on threads that end within a second; the window never waits for a picture.
class TrainWorkspace : public ui::Workspace {
  Q_OBJECT

 public:
  explicit TrainWorkspace(QWidget* parent = nullptr);
  ~TrainWorkspace() override;

  void setOpening(const QString& what) override;
  void setAccount(ui::Account& account) override;
  void setOrigin(const ui::CaseOrigin& origin) override;
  void setCase(std::shared_ptr<const PatientCase> patient) override;
  /// An attempt and a level go on with the case as it was; the saved one comes after them.
  void caseSaved(std::shared_ptr<const PatientCase> patient) override;
  QString statusText() const override;
  QString engineText() const override;
  QString engineNote() const override;
  /// Returns a sentence from the first live image on.
  QString endsWithTheCase() const override;
  QString blocksWorkspaceChange() const override;
  bool isReady() const override;
  /// Tells whether all surfaces are ready.
  bool isComplete() const override;
  QString helpPage() const override { return QStringLiteral("train"); }
  std::vector<ui::Shortcut> shortcuts() const override;
  void saveLayout(QSettings& settings) const override;
  void restoreLayout(QSettings& settings) override;
  void stop() override;

  /// Saves the image on display as PNG with its scale, and with measurements unless the user has switched them off.
  /// Continues in the background; written() or failed() report the end.
  void savePicture(const std::filesystem::path& file);
  /// Saves the image as the screen shows it, the CT beside it included, at the screen's resolution.
  void saveScreen(const std::filesystem::path& file);
  /// The last seconds as numbered PNGs like that of savePicture() in a new folder, as one of tasks(); written() or
  /// failed() tell the end.
  void saveClip(const std::filesystem::path& folder);

  /// Moves the linear probe with its own settings for a while and times the images on the screen, while 3D and CT
  /// follow or stand still. To be called when there is an image; `done` comes later, unless the workspace goes first.
  void measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done);
  /// Measures with a needle in the hand and 3D following.
  void measureHands(double seconds, std::function<void(HandRates)> done);
  /// Turns the patient in 3D, which takes its time.
  OrbitRates measureOrbit(int steps);
  /// Shows the CT in 3D and moves there and with the probe, `seconds` each; `done` comes later, unless the workspace
  /// goes first.
  void measureVolume(double seconds, std::function<void(VolumeRates)> done);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace insonate::train
