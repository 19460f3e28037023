#pragma once

#include <QMenu>
#include <QString>

namespace insonate::review {

class ClassDesk;
class PersonDesk;

/// Menu that saves the class's or the person's data as a page, a table or xAPI statements.
class SaveMenu final : public QMenu {
  Q_OBJECT

 public:
  enum class Subject { Class, Person };

  SaveMenu(Subject subject, ClassDesk& room, PersonDesk& person, QWidget* parent);

  void savePage(const QString& file);
  void saveTable(const QString& file);
  /// Saves all attempts as statements of a site with this home page; the data are queried and written on the account's
  /// thread.
  void saveXapi(const QString& file, const QString& homePage);

 Q_SIGNALS:
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 private:
  void add(const char* name, const QString& text, const QString& tip, const QString& ending,
           void (SaveMenu::*save)(const QString&));
  void askXapi(const QString& file);
  void tell(const QString& file, const QString& besides = {});
  QString fileName() const;

  const Subject subject_;
  ClassDesk& room_;
  PersonDesk& person_;
};

}  // namespace insonate::review
