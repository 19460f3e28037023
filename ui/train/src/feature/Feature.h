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
  bool wide = false;      ///< Shift was held
  bool repeated = false;  ///< sent repeatedly by a key that is held down
};

/// One feature of the workspace. The constructor adds the feature's widgets to the layout and connects them with the
/// model. The feature handles its own keys and saves its own settings. TrainWorkspace.cpp lists the features; they are
/// deleted in that order, before the widgets and the model.
class Feature : public QObject {
  Q_OBJECT

 public:
  /// `commands`: commands of the key table that this feature handles.
  Feature(TrainModel& model, TrainLayout& layout, std::initializer_list<Command> commands = {});

  /// Tells whether act() handles this command now.
  bool takes(Command command) const;
  /// Performs a command for which takes() is true.
  virtual void act(const KeyRow& /*row*/, KeyPress /*press*/) {}
  /// Tells whether a view handles a key itself although the key table contains it.
  virtual bool isViewKey(const QObject* /*canvas*/, const QKeyEvent& /*event*/) const { return false; }

  virtual void save(QSettings& /*settings*/) const {}
  virtual void restore(QSettings& /*settings*/) {}

  /// Sets the text about a case that is being opened; empty: no case is being opened.
  virtual void setOpening(const QString& /*what*/) {}
  virtual void setAccount(ui::Account& /*account*/) {}
  /// Uses shorter labels, for a narrow window.
  virtual void setCompact(bool /*isCompact*/) {}

  /// Sentence about what ends if another case is opened or the window is closed; empty if nothing does.
  virtual QString endsWithTheCase() const { return {}; }
  /// Tells whether the feature still needs the present state of the case although a newer state was saved.
  /// caseReleased() announces the end.
  virtual bool holdsCase() const { return false; }
  /// Tells whether the feature needs images while the workspace is hidden.
  virtual bool needsImages() const { return false; }
  /// Ends activities in progress, since the window closes.
  virtual void stop() {}

 Q_SIGNALS:
  void caseReleased();

 protected:
  /// Tells whether a command of this feature is available; by default if the image of a patient is shown.
  virtual bool isAvailable(Command command) const;

  TrainModel& model_;
  TrainLayout& layout_;

 private:
  std::vector<Command> commands_;
};

}  // namespace insonate::train
