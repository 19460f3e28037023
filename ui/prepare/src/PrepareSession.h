#pragma once

#include "check/CasePlaces.h"
#include "edit/Structures.h"
#include "label/LabelFollowers.h"
#include "label/LabelSession.h"
#include "live/LivePatient.h"
#include "measure/CaseMeasuring.h"
#include "table/LabelTerms.h"

#include <insonate/ui/Workspace.h>
#include <insonate/views/LabelStyle.h>
#include <insonate/views/WindowLevel.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::prepare {

/// Mediates between the controls and the views: a case, the look of its structures, its changes, and the crosshair.
/// Knows no widget but the bar of long jobs.
class PrepareSession : public QObject {
  Q_OBJECT

 public:
  PrepareSession(ui::TaskBar& tasks, QObject* parent);

  void setOrigin(const ui::CaseOrigin& origin);
  const ui::CaseOrigin& origin() const { return origin_; }
  /// Sets the case and discards edits; null for none.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Replaces the case by the same one with its changes saved.
  void replaceCase(std::shared_ptr<const PatientCase> patient);
  const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
  /// While asleep, no work begins and no image is made.
  void setAwake(bool awake);
  void stop();

  CaseMeasuring& measuring() { return measuring_; }
  LivePatient& live() { return live_; }
  LabelSession& labelling() { return labelling_; }
  const LabelSession& labelling() const { return labelling_; }
  const LabelFollowers& followers() const { return followers_; }

  /// Structures that occur or were added, in the table's order; empty before they are counted.
  const std::vector<std::uint8_t>& structures() const { return structures_; }
  const StructureLook& look(std::uint8_t label) const { return looks_[label]; }
  std::uint8_t selected() const { return selected_; }
  void select(std::uint8_t label);
  /// The next or previous structure of the table.
  void selectNext(int step);

  /// The author's name of it, or the label table's.
  QString nameOf(std::uint8_t label) const;
  LabelState stateOf(std::uint8_t label) const;
  bool hasVoxels(std::uint8_t label) const;

  /// Lists a structure that no voxel has yet, and selects it. One of the author's own can be undone.
  void addStructure(std::uint8_t label);

  /// Tools leave a locked label as it is.
  void setLocked(std::uint8_t label, bool locked);
  /// Changes all its voxels to soft tissue; an own structure without voxels is removed.
  void removeVoxels(std::uint8_t label);

  // Edits; each can be undone.
  QUndoStack& undoStack() { return undo_; }
  void setColour(std::uint8_t label, views::Colour colour);
  /// Sets an opacity; of one drag, the last value counts.
  void setOpacity(std::uint8_t label, double opacity);
  void setShareOnSlices(std::uint8_t label, double share);
  void setVisible(std::uint8_t label, bool visible);
  void showOnly(std::uint8_t label);
  void showAll();
  const QString& title() const { return title_; }
  void setTitle(const QString& title);
  /// Targets, landmarks, start poses and grade as they are now.
  const CasePlaces& places() const { return places_; }
  void setPlaces(CasePlaces places, const QString& what);
  /// Meaning of the author's own labels, and the author's progress on each label.
  const LabelTerms& terms() const { return terms_; }
  void setTerms(LabelTerms terms, const QString& what);
  /// Names one of the author's own labels. A name that another structure has is refused, with a sentence.
  void setName(std::uint8_t label, const QString& name);
  void setTissue(std::uint8_t label, std::uint8_t tissue);
  void setState(std::uint8_t label, LabelState state);
  void toNextState(std::uint8_t label);
  /// Edits beside voxels: looks and terms of structures, the title and the places.
  struct Said {
    StructureLooks looks;
    QString title;
    CasePlaces places;
    LabelTerms terms;
  };
  Said said() const { return {looks_, title_, places_, terms_}; }
  /// Edits what differs from it, as one step.
  void restoreSaid(const Said& said);
  /// Makes the probe's place the case's start pose, if it has none; saved with the case.
  void keepStart();
  /// Tells whether the case has no start pose, none is set, and the probe has a position.
  bool lacksStart() const;
  /// Changes that belong to the case and are not saved in it; null without any.
  ui::CaseEdit unsavedEdit();
  bool isUnsaved() const;
  /// Changes of visibility and opacity that are not saved in the case; null without any.
  ui::CaseEdit quietEdit() const;

  // Point and direction of view
  Vec3 crosshair_mm() const { return crosshair_mm_; }
  /// Sets the crosshair, clamped to the volume.
  void setCrosshair(Vec3 patient_mm);
  /// Moves to the place where the case begins.
  void goToStart();
  /// Crosshair and probe to a pose.
  void goTo(const StartPose& pose);
  const views::WindowLevel& windowLevel() const { return windowLevel_; }
  void setWindowLevel(views::WindowLevel value);
  double labelOpacity() const { return labelOpacity_; }
  void setLabelOpacity(double opacity);
  bool labelsShown() const { return labelsShown_; }
  void setLabelsShown(bool shown);
  const views::LabelStyle& labelStyle() const { return labelStyle_; }
  void setLabelStyle(const views::LabelStyle& style);
  /// Targets, landmarks and start poses, on slices and in 3D.
  bool placesShown() const { return placesShown_; }
  void setPlacesShown(bool shown);

  /// The user's choices for structures in other cases; applied to the next case.
  struct Habit {
    double opacity = 1;
    bool visible = true;
    double onSlices = 1;
  };
  const std::map<std::uint8_t, Habit>& habits() const { return habits_; }
  void setHabits(std::map<std::uint8_t, Habit> habits) { habits_ = std::move(habits); }

  /// Sets the point under a tool, which message() describes instead of the crosshair; none while there is none.
  void pointAt(std::optional<Vec3> patient_mm);

  /// Sentence about the last event; without one, about the voxel under the tool or the crosshair.
  QString message() const;
  /// Shows a sentence about an event for some seconds.
  void say(const QString& sentence);
  static constexpr int kSaid_ms = 7000;
  /// Maximum number of undoable edits: the steps that LabelEdit stores.
  static constexpr int kMostUndo = int(LabelEdit::kMostSteps);

 Q_SIGNALS:
  void caseChanged();
  void originChanged();
  void structuresChanged();
  void lookChanged(int label);
  void selectedChanged();
  void titleChanged();
  void placesChanged();
  void termsChanged();
  void editsChanged();
  void crosshairMoved();
  void slicesChanged();  ///< window, level, how labels lie on slices, and whether places are marked
  void messageChanged();

 private:
  friend class LookEdit;
  friend class TitleEdit;
  friend class PlacesEdit;
  friend class TermsEdit;
  void applyPlaces(const CasePlaces& places);
  void applyTerms(const LabelTerms& terms);
  void applyLook(std::uint8_t label, const StructureLook& look);
  void applyTitle(const QString& title);
  void push(std::uint8_t label, const StructureLook& look, const QString& what);
  void listStructures();
  std::vector<ui::SurfaceWish> missingSurfaces();
  std::vector<ui::SurfaceWish> changedSurfaces(const LabelSet& labels) const;
  void notifyHidden();
  void notifyEdits();
  QString placeText() const;

  ui::CaseOrigin origin_;
  std::shared_ptr<const PatientCase> patient_;
  std::vector<std::uint8_t> structures_;
  LabelSet added_;               ///< labels that are listed before they are counted
  StructureLooks looks_, kept_;  ///< now, and when the case was opened or saved
  std::map<std::uint8_t, Habit> habits_;
  std::array<bool, 256> surfaceWanted_{};
  std::uint8_t selected_ = 0;
  QString title_;
  CasePlaces places_;
  LabelTerms terms_;
  std::optional<StartPose> found_;  ///< where the probe began when the case was opened
  Vec3 crosshair_mm_;
  std::optional<Vec3> pointer_mm_;
  views::WindowLevel windowLevel_;
  double labelOpacity_ = 0.25;
  bool labelsShown_ = true, placesShown_ = true;
  views::LabelStyle labelStyle_;
  std::array<bool, 2> hadEdits_{};  ///< unsaved, quiet
  QString message_;
  QTimer said_, recheck_;
  QUndoStack undo_;
  CaseMeasuring measuring_;
  LivePatient live_;
  LabelSession labelling_;
  LabelFollowers followers_;
};

}  // namespace insonate::prepare
