#pragma once

#include <insonate/ui/HandsChoice.h>
#include <insonate/ui/Workspace.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace insonate::train {

class DevicesFeature;
class Feature;
class ImageExports;
class PatientViews;
class TrainBenchmark;
class TrainLayout;
struct TrainModel;

/// The workspace in which the user moves a probe over a patient and the ultrasound image follows: controls on the left,
/// the image in the middle, the patient in 3D and as CT on the right. Mouse and keyboard move the probe; commands()
/// lists the keys. Background threads compute the images; the window never waits for an image. When the window closes,
/// the threads end within a second.
class TrainWorkspace : public ui::Workspace {
  Q_OBJECT

 public:
  explicit TrainWorkspace(QWidget* parent = nullptr);
  ~TrainWorkspace() override;

  void setOpeningText(const QString& what) override;
  void setAccount(ui::Account& account) override;
  void setOrigin(const ui::CaseOrigin& origin) override;
  void setCase(std::shared_ptr<const PatientCase> patient) override;
  /// Shows the saved case. During an attempt or while a level is selected, the case is shown only after the attempt or
  /// level has ended.
  void caseSaved(std::shared_ptr<const PatientCase> patient) override;
  QString statusText() const override;
  QString engineText() const override;
  QString engineNote() const override;
  /// Returns a sentence while an attempt is in progress; else an empty text.
  QString interruptionWarning() const override;
  QString workspaceChangeBlocker() const override;
  bool isReady() const override;
  /// Tells whether all surfaces are ready.
  bool isComplete() const override;
  QString helpPage() const override { return QStringLiteral("train"); }
  void saveLayout(QSettings& settings) const override;
  void restoreLayout(QSettings& settings) override;
  void stop() override;

  /// Saves the displayed image as PNG with its scale, and with measurements unless the user has switched them off.
  /// Returns at once; emits written() or failed() when the file is complete.
  void saveImage(const std::filesystem::path& file);
  /// Saves the image as it appears on the screen, including the CT beside it, at the resolution of the screen.
  void saveScreen(const std::filesystem::path& file);
  /// Saves the images of the last seconds: as a video if `target` ends in .webm, as a DICOM clip if it ends in .dcm,
  /// else as numbered PNG files, each as saveImage() does, in the new folder `target`. Runs as a job of tasks();
  /// emits written() or failed() at the end.
  void saveClip(const std::filesystem::path& target);

  /// Assigns devices to probe and needle, and opens the windows in which the user sets them up.
  void setHands(ui::HandsChoice choice);

  /// Returns the benchmark of this workspace.
  TrainBenchmark& benchmark();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void addFeatures();
  template <class T, class... Parts>
  T& add(Parts&... parts);
  void connectModel();
  void takeSavedCase();
  void checkReady();
  void reportProblem();
  void takeKeyboard();

  TrainModel* model_;  ///< child object, deleted after the widgets
  std::unique_ptr<TrainLayout> layout_;
  std::vector<Feature*> features_;
  DevicesFeature* devices_ = nullptr;
  ImageExports* exports_ = nullptr;
  PatientViews* patient_ = nullptr;
  std::unique_ptr<TrainBenchmark> benchmark_;
  ui::CaseOrigin origin_;                         ///< origin of the case that setCase() will set next
  std::shared_ptr<const PatientCase> savedCase_;  ///< saved case that replaces the present case as soon as no feature
                                                  ///< needs the present case
  QString error_;                                 ///< reason why there is no image, if not reported yet
  bool isReady_ = false, isCoarse_ = false;
};

}  // namespace insonate::train
