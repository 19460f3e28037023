#pragma once

#include "model/TrainModel.h"

#include <insonate/train/TrainWorkspace.h>
#include <insonate/views/UltrasoundView.h>

#include <QAction>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

class QKeyEvent;
class QLabel;
class QSplitter;
class QStackedWidget;

namespace insonate {
struct AttemptFacts;
}

namespace insonate::ui {
class Account;
class ViewWidget;
}  // namespace insonate::ui

namespace insonate::train {

struct KeyRow;
class AttemptControl;
class AttemptKeeper;
class AttemptPanel;
class AttemptStrip;
class CineBar;
class ControlsPanel;
class Course;
class CoursePage;
class CtBeside;
class DevicePanel;
class EqualPanes;
class FovHandles;
class HeldPress;
class ImageExports;
class LevelControl;
class ImageInput;
class LinkedPointer;
class LiveMeasure;
class SceneMeasure;
class PatientViews;
class ProbeEditor;
class ProbeLibrary;
class SliceMeasure;
class TissueShown;

/// The parts of the workspace, and their connections.
class TrainWorkspace::Parts : public QObject {
 public:
  explicit Parts(TrainWorkspace& workspace);
  ~Parts() override;
  /// Stops listening to canvases: the mouse leaves a canvas that is destroyed, when other views may be gone.
  void releaseCanvases();

  TrainModel& model;  ///< a child of the workspace, gone after its widgets
  QSplitter* columns = nullptr;
  ControlsPanel* panel = nullptr;
  AttemptControl* attempt = nullptr;
  PatientViews* patient = nullptr;
  TissueShown* tissue = nullptr;
  ImageExports* exports = nullptr;
  QString engineText;
  DevicePanel* devices = nullptr;  ///< once it was asked for
  bool ready = false;

  bool isLeftHanded() const { return leftHanded_->isChecked(); }
  /// Haptic devices, beside the window.
  void showDevices();
  /// Controls on the right, patient on the left.
  void setLeftHanded(bool on);
  /// Shorter words, where the window is narrow.
  void setCompact(bool compact);
  bool isCtBeside() const { return besideAction_->isChecked(); }
  void setCtBeside(bool on);
  /// Widens the patient's column at the image's expense, or restores it.
  void expandPatientColumn(bool more);

  ui::CaseOrigin origin;  ///< of the case that comes next
  void setCase(std::shared_ptr<const PatientCase> opened);
  /// Replaces the case by its saved state: now, or once no attempt or level is in progress.
  void takeSaved(std::shared_ptr<const PatientCase> edited);
  void setAccount(ui::Account& account);
  /// Levels, attempts and the questionnaire in the place of image and controls.
  void showCourse(bool on);
  bool isCourseShown() const;
  /// One that is being made is kept as abandoned.
  void endAttempt();
  /// Shows why there is no image, once the user sees the workspace: during labeling the problem does not concern
  /// Train.
  void reportProblem();
  /// Shows which case is being opened, while no case is open; empty for none.
  void showOpening(const QString& what);
  bool key(const QKeyEvent& event, bool act);
  /// Handles keys of the table for canvases, and moves the keyboard focus to the image with the mouse.
  bool canvasEvent(QObject* canvas, QEvent* event);
  void measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done);
  void measureHands(double seconds, std::function<void(HandRates)> done);
  OrbitRates measureOrbit(int steps);
  void measureVolume(double seconds, std::function<void(VolumeRates)> done);

 private:
  QWidget* buildLeft();
  QWidget* buildCentre();
  void buildCourse();
  void judgeAttempt(const AttemptFacts& facts);
  void connectAttempt();
  void takeWaiting();
  void showAttempt();
  void applyDisclosure();
  QWidget* buildOffer();
  void showOffer();
  void showVesselNote();
  void buildActions();
  void connectParts();
  bool sliceKey(const QObject* canvas, const QKeyEvent& event) const;
  void clearCallipers();
  void showNotice();
  void act(const KeyRow& row, bool wide, bool repeated);
  void chooseCalliper(int kind);
  void showCallipers();
  void showPicture();
  void showCase();
  void showRate();
  void takeKeyboard(QObject* canvas);
  void connectProbe();
  void editProbe(bool on);
  void fitToPicture();

  TrainWorkspace& workspace_;
  std::shared_ptr<views::UltrasoundView> image_;
  ui::ViewWidget* imageWidget_ = nullptr;
  EqualPanes* pictures_ = nullptr;
  QLabel* empty_ = nullptr;
  QWidget* offer_ = nullptr;  ///< to place the probe
  QLabel* vesselNote_ = nullptr;
  ImageInput* input_ = nullptr;
  HeldPress* held_ = nullptr;
  CineBar* cine_ = nullptr;
  ProbeLibrary* library_ = nullptr;
  QWidget* leftColumn_ = nullptr;   ///< the attempt, and under it
  QStackedWidget* left_ = nullptr;  ///< the controls, or the probe's editor
  AttemptPanel* attemptPanel_ = nullptr;
  ProbeEditor* editor_ = nullptr;
  FovHandles* fov_ = nullptr;
  CtBeside* beside_ = nullptr;
  std::vector<SliceMeasure*> measureSlices_;  ///< one for each slice of the CT, wherever it stands
  LinkedPointer* pointer_ = nullptr;
  QAction *leftHanded_ = nullptr, *besideAction_ = nullptr, *courseAction_ = nullptr;
  ui::Account* account_ = nullptr;
  Course* course_ = nullptr;
  LevelControl* levels_ = nullptr;
  AttemptKeeper* keeper_ = nullptr;
  CoursePage* coursePage_ = nullptr;           ///< once it was asked for
  std::shared_ptr<const ImagingSetup> shape_;  ///< of the image as laid out
  std::shared_ptr<const PatientCase> saved_;   ///< waits for the end of what a trainee does
  QString trouble_;                            ///< that was not told yet
  QList<int> widthsBefore_;                    ///< of the columns, before the patient's had more room
  bool effectAlone_ = false;
  bool touchesTray_ = false;  ///< the used needle, in a hand
  std::unique_ptr<LiveMeasure> measure_;
  std::unique_ptr<SceneMeasure> volumeMeasure_;
  QTimer rate_;
};

}  // namespace insonate::train
