#pragma once

#include <insonate/ui/Commands.h>

#include <QObject>
#include <functional>
#include <initializer_list>
#include <vector>

class QAction;
class QSettings;

namespace insonate::ui {
class Account;
}

namespace insonate::train {

class TrainLayout;
struct TrainModel;

/// Sections of the list of keys, in the order in which the list shows them: sections that are needed first come first.
enum class KeySection { Probe, Needle, Image, Attempts, Measurements, Patient, Tissue, Undo };

/// One feature of the workspace. The constructor adds the feature's commands to the workspace's commands and its
/// widgets to the layout, and connects both with the model. The feature saves its own settings. TrainWorkspace.cpp
/// lists the features; they are deleted in that order, before the widgets and the model.
class Feature : public QObject {
  Q_OBJECT

 public:
  Feature(TrainModel& model, TrainLayout& layout);

  virtual void save(QSettings& /*settings*/) const {}
  virtual void restore(QSettings& /*settings*/) {}

  /// Sets the text about a case that is being opened; empty: no case is being opened.
  virtual void setOpeningText(const QString& /*what*/) {}
  virtual void setAccount(ui::Account& /*account*/) {}
  /// Uses shorter labels, for a narrow window.
  virtual void setCompact(bool /*isCompact*/) {}

  /// Returns a sentence about the activity that ends if another case is opened or the window is closed; empty if no
  /// activity ends.
  virtual QString interruptionWarning() const { return {}; }
  /// Tells whether the feature still needs the present state of the case although a newer state was saved.
  /// caseReleased() announces the end.
  virtual bool holdsCase() const { return false; }
  /// Tells whether the feature needs images while the workspace is hidden.
  virtual bool needsImages() const { return false; }
  /// Ends activities in progress, because the window closes.
  virtual void stop() {}

 Q_SIGNALS:
  void caseReleased();

 protected:
  using Perform = std::function<void(ui::KeyPress)>;

  /// The workspace's commands, which are used only while the features exist.
  ui::Commands& commands() const;
  /// Begins a section of the list of keys. Commands and gestures that are added next belong to the section.
  void beginSection(KeySection section);
  /// Adds a command. A command without its own condition is available while isPatientShown().
  void addCommand(ui::Command command);
  /// Adds a command that switches something on and off to the View menu, with a check mark while `isOn`. If something
  /// else switches it, the feature updates the check mark.
  QAction* addSwitch(const QString& id, std::function<bool()> isOn);
  /// Tells whether a patient is open and no page covers image and controls.
  bool isPatientShown() const;

  /// Returns keys that all perform the same function.
  static std::vector<ui::CommandKey> keys(std::initializer_list<int> pressed, Qt::KeyboardModifiers modifiers = {});
  /// Returns a function that performs only once, however long the key is held down.
  static Perform once(std::function<void()> perform);

  TrainModel& model_;
  TrainLayout& layout_;
};

}  // namespace insonate::train
