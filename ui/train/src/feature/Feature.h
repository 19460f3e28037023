#pragma once

#include "KeyTable.h"

#include <QObject>
#include <initializer_list>
#include <vector>

class QSettings;

namespace insonate::ui {
class Account;
}

namespace insonate::train {

class TrainLayout;
struct TrainModel;

/// Modifiers of a key press.
struct KeyPress {
  bool wide = false;      ///< with Shift
  bool repeated = false;  ///< by the key held down
};

/// One feature of the workspace. Its constructor puts its widgets into the layout and connects them with the model;
/// it handles its own keys and saves its own settings. TrainWorkspace.cpp lists the features; they are deleted in that
/// order, before the widgets and the model.
class Feature : public QObject {
  Q_OBJECT

 public:
  /// `commands`: those of the key table that the feature handles.
  Feature(TrainModel& model, TrainLayout& layout, std::initializer_list<Command> commands = {});

  /// Tells whether act() handles this command now.
  bool takes(Command command) const;
  /// Performs a command that it takes.
  virtual void act(const KeyRow& /*row*/, KeyPress /*press*/) {}
  /// Tells whether a view keeps a key that the table has.
  virtual bool isViewKey(const QObject* /*canvas*/, const QKeyEvent& /*event*/) const { return false; }

  virtual void save(QSettings& /*settings*/) const {}
  virtual void restore(QSettings& /*settings*/) {}

  /// Text about a case that is being opened; empty for none.
  virtual void setOpening(const QString& /*what*/) {}
  virtual void setAccount(ui::Account& /*account*/) {}
  /// Shortens words in a narrow window.
  virtual void setCompact(bool /*isCompact*/) {}

  /// Sentence about what another case, or closing the window, would end; empty for nothing.
  virtual QString endsWithTheCase() const { return {}; }
  /// Tells whether the case must stay as it is, although a newer state of it is saved. caseReleased() ends that.
  virtual bool holdsCase() const { return false; }
  /// Tells whether images are needed while the workspace is hidden.
  virtual bool needsImages() const { return false; }
  /// Ends what is in progress: the window closes.
  virtual void stop() {}

 Q_SIGNALS:
  void caseReleased();

 protected:
  /// Tells whether a command of this feature is available; by default while the image of a patient is shown.
  virtual bool isAvailable(Command command) const;

  TrainModel& model_;
  TrainLayout& layout_;

 private:
  std::vector<Command> commands_;
};

}  // namespace insonate::train
