#pragma once

#include "Tool.h"

#include <insonate/views/MprView.h>

#include <QObject>
#include <map>
#include <optional>

namespace insonate::prepare {

struct PrepareModel;

/// The tool that is in the author's hand: its parameters, the points that were clicked for it, its preview. Preview,
/// Enter and Esc mean the same for all tools. For the window's thread.
class ToolSession : public QObject {
  Q_OBJECT

 public:
  ToolSession(PrepareModel& shared, QObject* parent);

  /// The tool in hand; null without one: then the mouse moves the crosshair.
  const Tool* tool() const { return tool_; }
  /// Selects a tool by its id; an empty id deselects it. Clicks for another tool are cleared.
  void choose(const QString& id);
  /// Selects the former tool.
  void chooseLast();
  const LabelTool& parameters() const { return parameters_; }
  void setNumber(const ToolNumber& number, double value);
  void setChoice(const ToolChoice& choice, int index);
  void setRange(HuRange range);
  void setOther(std::uint8_t label);
  /// Range of a number in this case.
  ui::ValueRange rangeOf(const ToolNumber& number) const;

  const std::vector<Vec3>& points() const;
  void addPoint(Vec3 patient_mm, views::SliceKind slice);
  /// The tool is drawn over 3D, too.
  bool cutsScene() const;
  /// Its points lie before 3D, and not on a slice.
  bool isDrawnInScene() const { return sceneLook_.has_value() && !points().empty(); }
  /// Adds a corner drawn over 3D; the cut begins at the first corner's surface.
  void addScenePoint(Vec3 patient_mm, const ScissorsView& look);
  void removeNearest(Vec3 patient_mm);
  /// The Hounsfield units around a place become the range.
  void takeRange(Vec3 patient_mm);

  bool beginStroke(Vec3 patient_mm, views::SliceKind slice);
  void strokeTo(Vec3 patient_mm);
  void endStroke();
  double brushRadius_mm() const;
  bool brushIsFlat() const;
  void scaleBrush(double factor);

  /// Enough is clicked, and nothing else is at work.
  bool isComplete() const;
  void preview();
  void apply();
  /// Esc: stops a running step, else clears the clicks, else deselects the tool.
  void leave();

 Q_SIGNALS:
  void toolChanged();
  void parametersChanged();
  void pointsChanged();
  /// Why nothing came of it, until something else is done; empty then.
  void told(const QString& sentence);

 private:
  LabelStep step() const;
  void fillIn(LabelTool& tool) const;
  int axisOf(views::SliceKind slice) const;
  void changed();
  /// One is shown, or will be.
  bool isPreviewWanted() const;

  PrepareModel& shared_;
  const Tool* tool_ = nullptr;
  LabelTool parameters_;
  std::map<QString, LabelTool> kept_;  ///< parameters of tools that were used
  QString last_;
  std::optional<ScissorsView> sceneLook_;             ///< of the outline's first corner, where it is drawn over 3D
  views::SliceKind slice_ = views::SliceKind::Axial;  ///< that was used last
};

}  // namespace insonate::prepare
