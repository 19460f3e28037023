#pragma once

#include <insonate/ui/Workspace.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace insonate::train {

class Feature;
class ImageExports;
class PatientViews;
class TrainBenchmark;
class TrainLayout;
struct TrainModel;

/// The workspace where the user moves a probe over a patient and the ultrasound image follows: controls on the left,
/// the image in the middle, the patient in 3D and as CT on the right. Mouse and keyboard hold the probe; shortcuts()
/// lists their actions. Images are computed on threads that end within a second; the window never waits for one.
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

  /// Measures how fast this workspace is.
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
  bool key(const QKeyEvent& event, bool isPerformed);
  void takeKeyboard(const QObject* canvas);

  TrainModel* model_;  ///< a child, deleted after the widgets
  std::unique_ptr<TrainLayout> layout_;
  std::vector<Feature*> features_;
  ImageExports* exports_ = nullptr;
  PatientViews* patient_ = nullptr;
  std::unique_ptr<TrainBenchmark> benchmark_;
  ui::CaseOrigin origin_;                         ///< of the case that comes next
  std::shared_ptr<const PatientCase> savedCase_;  ///< waits until no feature holds the present one
  QString trouble_;                               ///< why there is no image; not reported yet
  bool isReady_ = false;
};

}  // namespace insonate::train
