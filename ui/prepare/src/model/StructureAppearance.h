#pragma once

#include "Structures.h"

#include <insonate/views/Theme.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>

class QSettings;
class QUndoCommand;

namespace insonate::prepare {

class LabelSession;
class OpenCase;
class StructureList;
class TermsEditor;

/// Edits how structures are drawn. Visibility and opacity are also stored as the user's defaults for other cases.
class StructureAppearance : public QObject {
  Q_OBJECT

 public:
  StructureAppearance(OpenCase& openCase, const StructureList& structures, const TermsEditor& terms,
                      LabelSession& labeling, QObject* parent);

  const StructureLook& look(std::uint8_t label) const { return looks_[label]; }
  const StructureLooks& looks() const { return looks_; }
  /// Appearance when the case was opened or last saved.
  const StructureLooks& savedLooks() const { return saved_; }
  void setColor(std::uint8_t label, views::Color color);
  /// Sets an opacity. Consecutive calls during a drag are undone together.
  void setOpacity(std::uint8_t label, double opacity);
  void setShareOnSlices(std::uint8_t label, double share);
  void setVisible(std::uint8_t label, bool visible);
  void showOnly(std::uint8_t label);
  void showAll();
  /// Adds to `all` edits that set these looks, for structures whose look differs from the present one.
  void restore(const StructureLooks& looks, QUndoCommand& all);

  /// Forbids tools to change labels that are not visible.
  void protectHidden();
  /// Saves the user's defaults, which restoreHabits() reads. The defaults apply from the next case on.
  void saveHabits(QSettings& settings) const;
  void restoreHabits(QSettings& settings);

 Q_SIGNALS:
  void lookChanged(int label);

 private:
  /// The user's default look of a structure.
  struct Habit {
    double opacity = 1;
    bool visible = true;
    double onSlices = 1;
  };

  void takeOver();
  QUndoCommand* edit(std::uint8_t label, const StructureLook& look, const QString& what, QUndoCommand* parent);
  void push(std::uint8_t label, const StructureLook& look, const QString& what);
  void apply(std::uint8_t label, const StructureLook& look);

  OpenCase& openCase_;
  const StructureList& structures_;
  const TermsEditor& terms_;
  LabelSession& labeling_;
  StructureLooks looks_, saved_;
  std::map<std::uint8_t, Habit> habits_;
};

}  // namespace insonate::prepare
