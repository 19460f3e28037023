#include <insonate/curriculum/ClassList.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ClassList listOf(const std::string& csv) {
  const auto list = parseClassList(csv);
  EXPECT_TRUE(list) << (list ? "" : list.error().message);
  return list ? *list : ClassList{};
}

TEST(ClassList, IsReadAsMoodleExportsIt) {
  const ClassList list = listOf(
      "\xEF\xBB\xBF\"First name\",\"Last name\",\"ID number\",\"Email address\",Groups\r\n"
      "Ada,Lovelace,M-17,Ada@example.org,\"A, B\"\r\n"
      "Zo\xC3\xAB,\"van \"\"der\"\" Berg\",,zoe@example.org,\r\n");
  EXPECT_TRUE(list.errors.empty());
  ASSERT_EQ(list.entries.size(), 2U);
  EXPECT_EQ(list.entries[0].person.fullName, "Ada Lovelace");
  EXPECT_EQ(list.entries[0].person.name, "M-17");
  EXPECT_EQ(list.entries[0].person.email, "Ada@example.org");
  EXPECT_EQ(list.entries[0].person.role, Role::Trainee);
  EXPECT_EQ(list.entries[1].person.fullName, "Zo\xC3\xAB van \"der\" Berg");
  EXPECT_EQ(list.entries[1].person.name, "zoe@example.org");
  EXPECT_EQ(list.entries[1].line, 3);
}

TEST(ClassList, OtherHeadsAndSemicolonsAreReadToo) {
  const ClassList list = listOf("USERNAME; full name ;e-mail\nada; Ada Lovelace ;\n");
  ASSERT_EQ(list.entries.size(), 1U);
  EXPECT_EQ(list.entries[0].person.name, "ada");
  EXPECT_EQ(list.entries[0].person.fullName, "Ada Lovelace");
  EXPECT_EQ(list.entries[0].person.email, "");
}

TEST(ClassList, GermanFrenchAndSpanishTitlesAreRead) {
  for (const char* csv :
       {"Nachname;Vorname;Anmeldename;E-Mail-Adresse\nMüller;Jörg;jm;jm@x.org\n",
        "Name;Vorname;Benutzername;E-Mail\nMüller;Jörg;jm;jm@x.org\n",
        "Prénom,Nom de famille,Nom d'utilisateur,Adresse de courriel\nJörg,Müller,jm,jm@x.org\n",
        "NOM,PRÉNOM,Identifiant,Courriel\nMüller,Jörg,jm,jm@x.org\n",
        "Nombre,Apellido(s),Nombre de usuario,Dirección de correo\nJörg,Müller,jm,jm@x.org\n",
        "Nombre completo;Usuario;Correo electrónico\nJörg Müller;jm;jm@x.org\n",
        "Nombre;Usuario;Correo\nJörg Müller;jm;jm@x.org\n", "Nom;Identifiant;Courriel\nJörg Müller;jm;jm@x.org\n",
        "Vollständiger Name;Vorname;Benutzername;E-Mail:\nJörg Müller;Jörg;jm;jm@x.org\n",
        "Vollständiger Name;Name;Vorname;Benutzername;Mail\nJörg Müller;Müller;Jörg;jm;jm@x.org\n",
        "Nombre;Primer apellido;Segundo apellido;Usuario;Correo\nJörg;Müller;;jm;jm@x.org;;\n;;;;\n"}) {
    const ClassList list = listOf(csv);
    ASSERT_EQ(list.entries.size(), 1U) << csv;
    EXPECT_EQ(list.entries[0].person.fullName, "Jörg Müller") << csv;
    EXPECT_EQ(list.entries[0].person.name, "jm") << csv;
    EXPECT_EQ(list.entries[0].person.email, "jm@x.org") << csv;
  }
}

TEST(ClassList, BothSurnamesAreKept) {
  const ClassList list = listOf("Nombre;Primer apellido;Segundo apellido;Correo\nJosé;García;Núñez;j@x.es\n");
  ASSERT_EQ(list.entries.size(), 1U);
  EXPECT_EQ(list.entries[0].person.fullName, "José García Núñez");
}

TEST(ClassList, MixedEncodingsAreRefusedWithTheLine) {
  for (const char* csv : {"Full name,Username\nJürgen,ju\nZo\xE9,zo\n",
                          "\xEF\xBB\xBF"
                          "Full name,Username\nJo,jo\nZo\xE9,zo\n"}) {
    const auto list = parseClassList(csv);
    ASSERT_FALSE(list);
    EXPECT_THAT(list.error().message, HasSubstr("Line 3 is not UTF-8"));
  }
}

TEST(ClassList, AnotherPersonIsNotTakenForOneWithTheSameNumber) {
  const std::vector<Person> people{{"1", "1", "Anna Alt", "anna@x.org"}};
  const ClassListMatch match =
      matchClassList(listOf("full name,id,email\nCarl Neu,1,\nZoe Anders,7,anna@x.org\n"), people);
  ASSERT_EQ(match.errors.size(), 2U);
  EXPECT_THAT(match.errors[0].sentence, HasSubstr("sign-in name of Anna Alt, but the list says Carl Neu"));
  EXPECT_THAT(match.errors[1].sentence, HasSubstr("e-mail address of Anna Alt, but the list says Zoe Anders"));
  EXPECT_TRUE(match.known.empty());
}

TEST(ClassList, OldSpreadsheetsAreRead) {
  const ClassList list =
      listOf("Vorname;Nachname;Benutzername\nJ\xF6rg;M\xFCller \x96 \x8Aulc;jm\nZo\xEB;O\x92Hara;zo\n");
  ASSERT_EQ(list.entries.size(), 2U);
  EXPECT_EQ(list.entries[0].person.fullName, "Jörg Müller – Šulc");
  EXPECT_EQ(list.entries[1].person.fullName, "Zoë O’Hara");
  EXPECT_FALSE(parseClassList("\xFF\xFEN\0a\0"));
}

TEST(ClassList, EachWrongLineIsToldAndCostsItselfAlone) {
  const ClassList list = listOf(
      "name,email,username\n"
      ",a@x.org,a\n"        // 2
      "B,b at x.org,b\n"    // 3
      "C,,\n"               // 4
      "D,d@x.org,d d\n"     // 5
      "E,e@x.org,e\n"       // 6
      "F,E@X.org,f\n"       // 7: the e-mail of 6
      "G,g@x.org,E\n"       // 8: the name of 6
      "H,h@x.org,h,more\n"  // 9
      "I,i@x.org,i\n");     // 10
  std::vector<std::string> sentences;
  for (const ClassListError& error : list.errors) sentences.push_back(error.sentence);
  EXPECT_THAT(sentences,
              ElementsAre(HasSubstr("Line 2: The name is missing"), HasSubstr("Line 3: 'b at x.org' is not an e-mail"),
                          HasSubstr("Line 4: There is neither user name"), HasSubstr("Line 5: A sign-in name has"),
                          HasSubstr("Line 7: This person is the same as in line 6"),
                          HasSubstr("Line 8: This person is the same as in line 6"),
                          HasSubstr("Line 9: This line has more fields")));
  ASSERT_EQ(list.entries.size(), 2U);
  EXPECT_EQ(list.entries[0].line, 6);
  EXPECT_EQ(list.entries[1].line, 10);
}

TEST(ClassList, WhatIsNoClassListIsRefused) {
  EXPECT_THAT(parseClassList("").error().message, HasSubstr("is empty"));
  EXPECT_THAT(parseClassList("email\na@x.org").error().message, HasSubstr("has no names"));
  EXPECT_THAT(parseClassList("First name,email\nA,a@x.org").error().message, HasSubstr("has no names"));
  EXPECT_THAT(parseClassList("name\nA").error().message, HasSubstr("no column that identifies people"));
  EXPECT_THAT(parseClassList("name,email\n\"A").error().message, HasSubstr("never closed"));
}

TEST(ClassList, TwoColumnsWithOneTitleAreRefusedByName) {
  EXPECT_THAT(parseClassList("name,E-Mail,username, e-mail:\nA,a@x.org,a,b@x.org").error().message,
              HasSubstr("two columns with the title \"e-mail:\""));
  EXPECT_EQ(listOf("name,notes,username,notes\nA,x,a,y").entries.size(), 1U) << "columns that are not read";
}

TEST(ClassList, TwoTitlesOfOneFieldAreRefused) {
  EXPECT_EQ(
      parseClassList("name,E-Mail,username,Mail\nA,a@x.org,a,b@x.org").error().message,
      "The columns \"E-Mail\" and \"Mail\" of the class list have the same meaning. Delete one of them or give it "
      "another title.");
  EXPECT_THAT(parseClassList("Full name,Name,username\nA,B,a").error().message,
              HasSubstr("\"Full name\" and \"Name\""));
  EXPECT_EQ(listOf("first name,name,username\nAda,Lovelace,a").entries.at(0).person.fullName, "Ada Lovelace");
}

TEST(ClassList, MoodlesListOfAllUsersIsReadByIdNumber) {
  for (const char* titles : {"id,fullname,idnumber", "ID number,fullname,id"}) {
    const bool idFirst = titles[1] == 'd';
    const auto list = listOf(std::string(titles) + (idFirst ? "\n17,Ada L,s-4711" : "\ns-4711,Ada L,17"));
    EXPECT_EQ(list.entries.at(0).person.name, "s-4711") << titles;
  }
}

TEST(ClassList, ANoBreakSpaceIsNoPartOfAName) {
  EXPECT_EQ(listOf("sep=;\nname;username\nMax;\u00A0-max\n").entries.at(0).person.name, "-max");
}

TEST(ClassList, PeopleAreFoundByMailOrName) {
  const std::vector<Person> people{{"1", "ada", "Ada Lovelace", "ada@example.org"},
                                   {"2", "bob", "Bob", ""},
                                   {"3", "cyd", "Cyd", "cyd@example.org"},
                                   {"4", "dee", "Dee", "same@example.org"},
                                   {"5", "eve", "Eve", "same@example.org"}};
  const ClassList list = listOf(
      "name,username,email\n"
      "A. Lovelace,al,ADA@example.org\n"  // 2: known by mail
      "Bob,BOB,bob@example.org\n"         // 3: known by name, who has no mail yet
      "Cyd,cyd,other@example.org\n"       // 4: another mail
      "Dee,dee,same@example.org\n"        // 5: two people have it
      "Cyd,ada,cyd@example.org\n"         // 6: the mail of one, the name of another
      "New,new,new@example.org\n");       // 7
  const ClassListMatch match = matchClassList(list, people);
  ASSERT_EQ(match.known.size(), 2U);
  EXPECT_EQ(match.known[0].person.id, "1");
  EXPECT_EQ(match.known[1].person.id, "2");
  ASSERT_EQ(match.added.size(), 1U);
  EXPECT_EQ(match.added[0].person.name, "new");
  ASSERT_EQ(match.errors.size(), 3U);
  EXPECT_THAT(match.errors[0].sentence, HasSubstr("Line 4: This is the name 'cyd' of Cyd, who has another e-mail"));
  EXPECT_THAT(match.errors[1].sentence, HasSubstr("Line 5: Several people have this e-mail address"));
  EXPECT_THAT(match.errors[2].sentence, HasSubstr("of Cyd, but the name 'ada' of Ada Lovelace"));
}

}  // namespace
}  // namespace insonate
