#pragma once

#include "Tool.h"

#include <insonate/views/MprView.h>

#include <QObject>
#include <map>
#include <optional>

namespace insonate::prepare {

struct PrepareModel;

/// The selected tool, its parameters, the points that were clicked for the tool, and its preview. Preview, Enter and
/// Esc have the same meaning for all tools. May be used only on the window's thread.
class ToolSession : public QObject {
  Q_OBJECT

 public:
  ToolSession(PrepareModel& shared, QObject* parent);

  /// The selected tool; null: no tool, so that the mouse moves the crosshair.
  const Tool* tool() const { return tool_; }
  /// Selects a tool by its id; an empty id deselects the tool. Points clicked for another tool are removed.
  void choose(const QString& id);
  /// Selects the tool that was selected last.
  void chooseLast();
  const LabelTool& parameters() const { return parameters_; }
  void setNumber(const ToolNumber& number, double value);
  void setChoice(const ToolChoice& choice, int index);
  void setRange(HuRange range);
  void setOther(std::uint8_t label);
  /// Returns the permitted range of a parameter in this case.
  ui::ValueRange rangeOf(const ToolNumber& number) const;

  const std::vector<Vec3>& points() const;
  void addPoint(Vec3 patient_mm, views::SliceKind slice);
  /// Tells whether the tool can also be drawn over 3D.
  bool cutsScene() const;
  /// Tells whether the tool's points were drawn over 3D, not on a slice.
  bool isDrawnInScene() const { return sceneLook_.has_value() && !points().empty(); }
  /// Adds a corner of an outline drawn over 3D; the cut begins at the surface under the first corner.
  void addScenePoint(Vec3 patient_mm, const ScissorsView& look);
  void removeNearest(Vec3 patient_mm);
  void clearPoints();
  /// Sets the range of the tool to the Hounsfield units around a point.
  void takeRange(Vec3 patient_mm);

  bool beginStroke(Vec3 patient_mm, views::SliceKind slice);
  void strokeTo(Vec3 patient_mm);
  void endStroke();
  double brushRadius_mm() const;
  bool brushIsFlat() const;
  /// Factor of one step of a key or the wheel, for scaleBrush().
  static constexpr double kBrushStep = 1.15;
  void scaleBrush(double factor);

  /// Tells whether enough points were clicked and no other tool is running.
  bool isComplete() const;
  void preview();
  void apply();
  /// Performs the action of Esc: stops a running step, else removes the points, else deselects the tool.
  void leave();

 Q_SIGNALS:
  void toolChanged();
  void parametersChanged();
  void pointsChanged();
  /// Emitted with the reason why a step had no result; emitted with an empty text at the next action.
  void messageReported(const QString& sentence);

 private:
  LabelStep step() const;
  void fillIn(LabelTool& tool) const;
  int axisOf(views::SliceKind slice) const;
  void changed();
  /// Tells whether a preview is shown or requested.
  bool isPreviewRequested() const;

  PrepareModel& shared_;
  const Tool* tool_ = nullptr;
  LabelTool parameters_;
  std::map<QString, LabelTool> kept_;  ///< parameters of the tools that were used before
  QString last_;
  std::optional<ScissorsView> sceneLook_;  ///< view at the outline's first corner, for an outline drawn over 3D
  views::SliceKind slice_ = views::SliceKind::Axial;  ///< kind of the slice that was used last
};

}  // namespace insonate::prepare
