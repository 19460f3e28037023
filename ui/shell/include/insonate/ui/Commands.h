#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <map>
#include <vector>

class QAbstractButton;
class QAction;
class QEvent;
class QKeyEvent;
class QKeySequence;

namespace insonate::ui {

/// A key or a mouse gesture as the list of keys (`?`) shows it.
struct Shortcut {
  QString keys;  ///< keys as printed on the keyboard, e.g. "Shift + arrows"
  QString does;  ///< effect of the keys, e.g. "tilt and rock the probe"
};

/// Shortcuts of one part of the window, listed under a common heading.
struct ShortcutGroup {
  QString place;
  std::vector<Shortcut> shortcuts;
};

/// Modifiers of a key press.
struct KeyPress {
  bool wide = false;      ///< true: Shift was held
  bool repeated = false;  ///< true: sent repeatedly by a key that is held down
};

/// One key of a command. Shift selects the wide step of the same key.
struct CommandKey {
  int key = 0;                                      ///< code of the key: Qt::Key
  Qt::KeyboardModifiers modifiers{};                ///< Ctrl and Alt that must be held
  std::function<void(KeyPress)> perform = nullptr;  ///< function of this key; null: Command::perform
};

/// A command, which the user can give by a key, and also by a menu entry (action()) or a button (toolTip()).
struct Command {
  QString id;      ///< unique id "workspace.feature.act", e.g. "train.image.freeze"
  QString text;    ///< text of the menu entry, e.g. "Freeze image"; may be empty for a command without a menu entry
  QString does;    ///< effect, for tooltips and the list of keys, e.g. "freezes the image, or continues with live
                   ///< images"
  QString listed;  ///< keys as listed for the user, e.g. "Arrows"; empty: not listed
  std::vector<CommandKey> keys;
  /// performs the command: for keys without a function of their own, and for action()
  std::function<void(KeyPress)> perform;
  std::function<bool()> isAvailable = nullptr;  ///< tells whether the command can be given now; null: always
};

/// Registry of all commands of one workspace. Keys, menu entries, tooltips and the list of keys are made from this
/// registry. Features add their commands when they are constructed. May be used only on the window's thread.
class Commands : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Begins a section of the list of keys. Commands and gestures that are added next belong to this section. If the
  /// heading was used before, its section is continued.
  void beginSection(const QString& heading);
  /// Adds a command. Its id and its keys must not be in use by another command.
  void add(Command command);
  /// Adds a command for a Qt action, with the text of the action. The action itself handles its keys; the list shows
  /// the first of them. Sets the tooltip of the action.
  void add(const QString& id, const QString& does, QAction& action);
  /// Adds a command for a button, with the text of the button. Sets the key as the shortcut of the button, and its
  /// tooltip.
  void add(const QString& id, const QString& does, QAbstractButton& button, const QKeySequence& key);
  /// Adds a mouse gesture, or a key that an action or a widget handles itself, to the list of keys only.
  void addListed(const QString& keys, const QString& does);

  /// Performs the available command that has this key; if `isPerformed` is false, only searches for the command.
  /// @returns whether there is such a command
  bool key(const QKeyEvent& event, bool isPerformed) const;
  /// Handles a key event of a canvas. Keys of commands take precedence over shortcuts of the window. @returns whether
  /// the event is consumed
  bool handleKeyEvent(QEvent& event) const;

  /// Returns the command with this id; null if there is none.
  const Command* find(const QString& id) const;
  /// Returns the sentence about what a command does, followed by its keys, for the tooltip of a button; empty if there
  /// is no such command.
  QString toolTip(const QString& id) const;
  /// Returns the given sentence followed by the keys of a command, for a button to which the command applies in some
  /// states only.
  QString toolTip(const QString& sentence, const QString& id) const;
  /// Returns an action that performs a command, for a menu: the action with which the command was added, else an action
  /// that is made at the first call and owned by this object. Null if there is no such command. An action that is made
  /// here only shows the first key; key() handles the key.
  QAction* action(const QString& id);

  /// Returns the list of keys, by section, without empty sections.
  std::vector<ShortcutGroup> shortcuts() const;
  const std::vector<Command>& all() const { return commands_; }

 private:
  const Command* commandOf(const QKeyEvent& event, const CommandKey*& key) const;

  std::vector<Command> commands_;
  std::vector<ShortcutGroup> sections_;
  std::map<QString, QPointer<QAction>> actions_;
  std::size_t section_ = 0;  ///< the section that is being filled
};

}  // namespace insonate::ui
