#pragma once

#include <QMenu>
#include <QString>
#include <QStringList>

namespace insonate::ui {
class TaskBar;
}

namespace insonate::review {

class ClassController;
class PersonController;
struct Portfolio;

/// Menu that saves the class's or the person's data as a page, a table or xAPI statements.
class SaveMenu final : public QMenu {
  Q_OBJECT

 public:
  enum class Subject { Class, Person };

  SaveMenu(Subject subject, ClassController& room, PersonController& person, ui::TaskBar& tasks, QWidget* parent);

  /// Adds the entry that saves the person's portfolio.
  QAction& addPortfolio();

  void savePage(const QString& file);
  void saveTable(const QString& file);
  /// Writes the share of levels that each trainee of the class has mastered, for Moodle. Trainees are identified by
  /// their e-mail addresses, or by their names if no trainee has an e-mail address.
  void saveGrades(const QString& file);
  /// Writes the person's portfolio as PDF in the background, with progress in the task bar. If a task is running there,
  /// the portfolio is written after that task.
  void savePortfolio(const QString& file);
  /// Returns the name of a person whose portfolio waits until another task has ended; empty if there is none.
  QString waitingPortfolio() const { return waiting_.value(0); }
  /// Saves all attempts as statements of a site with this home page; the data are queried and written on the account's
  /// thread.
  void saveXapi(const QString& file, const QString& homePage);

 Q_SIGNALS:
  /// Emitted when a file was written. `folder` is empty if the file will be written later.
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 private:
  QAction* add(const char* name, const QString& text, const QString& tip, const QString& ending,
               void (SaveMenu::*save)(const QString&), const QString& part = {});
  void askXapi(const QString& file);
  void writePages(const QString& file, Portfolio portfolio);
  void writeLater(const QString& file, Portfolio portfolio);
  void tell(const QString& file, const QString& besides = {});
  /// Name of the class or person; letters that are special in file names are replaced.
  QString fileName() const;

  const Subject subject_;
  ClassController& room_;
  PersonController& person_;
  ui::TaskBar& tasks_;
  QStringList waiting_;  ///< names of the people whose portfolios wait until another task has ended
};

}  // namespace insonate::review
