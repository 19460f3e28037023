#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>

#include <QFuture>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>
#include <string>

namespace insonate {
struct Curriculum;
struct Level;
}  // namespace insonate

namespace insonate::ui {
class Account;
}

namespace insonate::train {

class AttemptControl;

/// Curriculum and level that an attempt counts for; null in free practice.
struct AttemptAim {
  const Curriculum* curriculum = nullptr;
  const Level* level = nullptr;
};

/// Result of writing facts on this computer: empty if they were written, else the facts themselves.
using KeptFacts = QFuture<std::optional<AttemptFacts>>;

/// Stores each attempt of the signed-in user, at its beginning and at its end, with the facts of its recording; the
/// store keeps a copy of the recording. Facts are first written on this computer, so that nothing is lost while the
/// store cannot be reached. Waiting facts are sent once a minute, when a server is reachable again, and when the user
/// whom the facts concern signs in. Signing out ends an attempt as abandoned. Attempts of guests are not stored. The
/// seal of the next attempt's recording is requested beforehand, so that the attempt begins at once, even while a
/// server is unreachable. May be used only on the window's thread; no call blocks.
class AttemptSaver final : public QObject {
  Q_OBJECT

 public:
  AttemptSaver(AttemptControl& attempt, QString folder, QObject* parent = nullptr);

  void setAccount(ui::Account& account);
  /// Sets the function that returns curriculum and level of an attempt when the attempt begins.
  void setNeedlePath(std::function<AttemptAim()> aim) { aim_ = std::move(aim); }
  /// Sets the function that returns the probable sitting of an attempt that begins now, for ended(). The store decides
  /// the sitting.
  void setSitting(std::function<TestConditions(const Level&)> testConditions) { sitting_ = std::move(testConditions); }
  /// Prepares the next attempt after the curriculum or level has changed.
  void prepare();

 Q_SIGNALS:
  /// Emitted when an attempt of the signed-in user has ended, before its facts are sent to the store.
  void ended(const insonate::AttemptFacts& facts);
  /// Emitted when the store has all facts of the signed-in user.
  void allSent();
  /// Emitted with a sentence when facts could not be sent.
  void messageReported(const QString& sentence);

 private:
  /// A seal for the next attempt, valid for one person, curriculum and level.
  struct Sealed {
    AttemptFacts facts{};
    AttemptSeal seal{};
  };
  bool isKept() const;
  AttemptFacts nextFacts() const;
  void start();
  void takeSeal(Result<Sealed> sealed);
  void begin();
  void end();
  void keep(const AttemptFacts& facts, const QString& recording);
  void send(const std::optional<KeptFacts>& fresh);
  void tell(const Result<std::string>& sent, bool isFresh);

  AttemptControl& attempt_;
  ui::Account* account_ = nullptr;
  const QString folder_;
  std::function<AttemptAim()> aim_;
  std::function<TestConditions(const Level&)> sitting_;
  std::optional<AttemptFacts> facts_;  ///< facts of the running attempt
  std::optional<Sealed> next_;
  std::string starter_;     ///< id of the user who started the present attempt; "": a guest
  bool isAwaited_ = false;  ///< true: a starting attempt waits for the seal
  std::string error_;       ///< last error that was reported
  QTimer again_;
};

}  // namespace insonate::train
