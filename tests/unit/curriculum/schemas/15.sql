PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE schema_migrations (number INTEGER NOT NULL PRIMARY KEY, applied_us INTEGER NOT NULL) STRICT;
INSERT INTO schema_migrations VALUES(1,1795364391703922);
INSERT INTO schema_migrations VALUES(2,1795387273314752);
INSERT INTO schema_migrations VALUES(3,1795610000000000);
INSERT INTO schema_migrations VALUES(4,1795620000000000);
INSERT INTO schema_migrations VALUES(5,1795630000000000);
INSERT INTO schema_migrations VALUES(6,1795700000000000);
INSERT INTO schema_migrations VALUES(7,1795700001000000);
INSERT INTO schema_migrations VALUES(8,1795880000000000);
INSERT INTO schema_migrations VALUES(9,1795900000000000);
INSERT INTO schema_migrations VALUES(10,1795900000000001);
INSERT INTO schema_migrations VALUES(11,1795900000000002);
INSERT INTO schema_migrations VALUES(12,1795910000000000);
INSERT INTO schema_migrations VALUES(13,1795920000000000);
INSERT INTO schema_migrations VALUES(14,1795920000000001);
INSERT INTO schema_migrations VALUES(15,1795930000000001);
CREATE TABLE people (
  id TEXT NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  name TEXT NOT NULL,
  name_key TEXT NOT NULL UNIQUE,
  full_name TEXT NOT NULL,
  email TEXT NOT NULL,
  role TEXT NOT NULL CHECK (role IN ('trainee', 'instructor', 'administrator')),
  disabled INTEGER NOT NULL CHECK (disabled IN (0, 1))
) STRICT;
INSERT INTO people VALUES('8170ddc4-af03-4e39-b267-e0410f16454f','admin','admin','Ada Min','','administrator',0);
INSERT INTO people VALUES('f88474d0-4839-4930-8827-26b3911be7d3','ina','ina','Dr ina','ina@example.org','instructor',0);
INSERT INTO people VALUES('3a0500d2-61df-4ad6-b315-0c47d24f0c49','otto','otto','Dr otto','otto@example.org','instructor',0);
INSERT INTO people VALUES('03a421d2-5528-4e5e-9242-ebc9dca3aa48','anna','anna','Dr anna','anna@example.org','trainee',0);
INSERT INTO people VALUES('cb19eef1-2e68-438e-94b8-27cfbc4ba9a7','ben','ben','Dr ben','ben@example.org','trainee',0);
INSERT INTO people VALUES('874ec70e-fc1d-4a61-bfae-2327ffac9b23','carl','carl','Dr carl','carl@example.org','trainee',0);
CREATE TABLE credentials (
  person TEXT NOT NULL PRIMARY KEY REFERENCES people (id),
  password TEXT NOT NULL,
  must_change INTEGER NOT NULL CHECK (must_change IN (0, 1)),
  version INTEGER NOT NULL
) STRICT;
INSERT INTO credentials VALUES('8170ddc4-af03-4e39-b267-e0410f16454f','$argon2id$v=19$m=8,t=1,p=1$QQMwncvvraJ8zQNtCd7tug$50Vizj28eO5wlUblQx4eGSVbawANZS4BnyqGuWwDCOM',0,1);
INSERT INTO credentials VALUES('f88474d0-4839-4930-8827-26b3911be7d3','$argon2id$v=19$m=8,t=1,p=1$GHlM3h7Lu5sIRdWWBjlnew$gXVb/Bfl5dI08xZMdtg2JQTPZNGM6yNR7TzHj3NytVo',0,2);
INSERT INTO credentials VALUES('3a0500d2-61df-4ad6-b315-0c47d24f0c49','$argon2id$v=19$m=8,t=1,p=1$BLoGy8mq1oJufF9OEcCfLA$rkX+WsSdM3yuhoXdBuobVBdKqp08P84YhdVwt0dr3gc',0,2);
INSERT INTO credentials VALUES('03a421d2-5528-4e5e-9242-ebc9dca3aa48','$argon2id$v=19$m=8,t=1,p=1$xA9Hd4LhkeQgRBZ9Yg9zhw$pYMt/0/wgYri+XRSH8S0wf37R6IC9hWDkFNSMMxeGw4',0,2);
INSERT INTO credentials VALUES('cb19eef1-2e68-438e-94b8-27cfbc4ba9a7','$argon2id$v=19$m=8,t=1,p=1$dB1wD8u0IHonPXRBwojWQw$Rz7vKJmj3kiu50CPnmUM0wzpG8dAD8n5vneOPuxVuc0',0,2);
INSERT INTO credentials VALUES('874ec70e-fc1d-4a61-bfae-2327ffac9b23','$argon2id$v=19$m=8,t=1,p=1$8bW6T1YL/kSIGvvcl0jHrA$SnZh7h11sXr7MEEeRKXd8GFExkt2wfhD83uXhGfY7LI',0,2);
CREATE TABLE sign_in_failures (
  name_hash TEXT NOT NULL PRIMARY KEY,
  failures INTEGER NOT NULL,
  last_us INTEGER NOT NULL,
  boot TEXT NOT NULL,
  up_us INTEGER NOT NULL
) STRICT;
CREATE TABLE cohorts (
  id TEXT NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  name TEXT NOT NULL,
  name_key TEXT NOT NULL UNIQUE,
  curriculum TEXT NOT NULL,
  curriculum_version INTEGER NOT NULL,
  archived INTEGER NOT NULL DEFAULT 0 CHECK (archived IN (0, 1))
) STRICT;
INSERT INTO cohorts VALUES('551a7610-87a8-4f8d-abc5-699a11eb1587','Spring','spring','central_line',1,0);
INSERT INTO cohorts VALUES('c66013b6-0b6f-49ab-a403-a5091618bcc3','Autumn','autumn','',0,0);
CREATE TABLE memberships (
  cohort TEXT NOT NULL REFERENCES cohorts (id),
  person TEXT NOT NULL REFERENCES people (id),
  teaches INTEGER NOT NULL CHECK (teaches IN (0, 1)),
  PRIMARY KEY (cohort, person)
) STRICT;
INSERT INTO memberships VALUES('551a7610-87a8-4f8d-abc5-699a11eb1587','f88474d0-4839-4930-8827-26b3911be7d3',1);
INSERT INTO memberships VALUES('c66013b6-0b6f-49ab-a403-a5091618bcc3','3a0500d2-61df-4ad6-b315-0c47d24f0c49',1);
INSERT INTO memberships VALUES('551a7610-87a8-4f8d-abc5-699a11eb1587','03a421d2-5528-4e5e-9242-ebc9dca3aa48',0);
INSERT INTO memberships VALUES('551a7610-87a8-4f8d-abc5-699a11eb1587','cb19eef1-2e68-438e-94b8-27cfbc4ba9a7',0);
INSERT INTO memberships VALUES('c66013b6-0b6f-49ab-a403-a5091618bcc3','874ec70e-fc1d-4a61-bfae-2327ffac9b23',0);
CREATE TABLE curricula (
  name TEXT NOT NULL,
  version INTEGER NOT NULL CHECK (version > 0),
  text TEXT NOT NULL,
  hash TEXT NOT NULL CHECK (length(hash) = 64),
  published_us INTEGER NOT NULL,
  published_by TEXT NOT NULL,
  PRIMARY KEY (name, version)
) STRICT;
INSERT INTO curricula VALUES('central_line',1,replace('{\n  "name": "central_line",\n  "title": "Central line",\n  "about": "From the first jugular puncture on a neck as in the textbook to the vein below the clavicle. Cases are the built-in necks (insonate-cli phantom --list).",\n  "version": 1,\n  "levels": [\n    {\n      "name": "jugular_first",\n      "title": "First jugular line",\n      "about": "A wide vein beside the artery. Learn the steps: find the vein, go in at 45 degrees, stop in its middle, draw blood.",\n      "case": "textbook",\n      "procedure": "internal_jugular",\n      "position": "Trendelenburg 15",\n      "assistance": "guided",\n      "prerequisites": [],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_alone",\n      "title": "Jugular line without a guide",\n      "about": "The same neck; nobody says the next step.",\n      "case": "textbook",\n      "procedure": "internal_jugular",\n      "position": "Trendelenburg 15",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_first"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_muscle",\n      "title": "Under a thick muscle",\n      "about": "The vein lies deeper, under a strong sternocleidomastoid: choose the way before you go in.",\n      "case": "large-sternomastoid",\n      "procedure": "internal_jugular",\n      "position": "Trendelenburg 15",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_alone"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_two_arteries",\n      "title": "Two arteries",\n      "about": "The carotid divides low: two round, beating vessels lie beside the vein. Tell them apart by pressing.",\n      "case": "low-bifurcation",\n      "procedure": "internal_jugular",\n      "position": "Trendelenburg 15",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_alone"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_small",\n      "title": "A small vein",\n      "about": "The right vein has less than half of its usual area. Fill it by position, or choose the other side.",\n      "case": "small-vein",\n      "procedure": "internal_jugular",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_alone"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_turned",\n      "title": "Head turned",\n      "about": "Muscle and vein have slid over the artery. Aim so that a needle that goes too far does not meet it.",\n      "case": "head-turned",\n      "procedure": "internal_jugular",\n      "position": "Trendelenburg 15",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_alone"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_fat",\n      "title": "Deep in fat",\n      "about": "More than 20 mm to the vein: a longer way to keep the tip in the picture.",\n      "case": "deep-in-fat",\n      "procedure": "internal_jugular",\n      "position": "Trendelenburg 15",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_muscle"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_flat",\n      "title": "An empty vein",\n      "about": "Low filling: slits of 4 mm that any pressure closes. Tilt the head down and hardly touch the skin.",\n      "case": "collapsed-vein",\n      "procedure": "internal_jugular",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_small"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_over_artery",\n      "title": "Vein over artery",\n      "about": "The vein lies in front of the carotid: who goes through it meets the artery.",\n      "case": "vein-over-artery",\n      "procedure": "internal_jugular",\n      "position": "Trendelenburg 15",\n      "assistance": "hints",\n      "prerequisites": [\n        "jugular_two_arteries",\n        "jugular_turned"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 3.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule: complications grow beyond three."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 149.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "The procedure''s norm of novices."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "jugular_test",\n      "title": "Jugular test",\n      "about": "A neck that was not practised on, without hints and without CT, until it can be relied on.",\n      "case": "high-bifurcation",\n      "procedure": "internal_jugular",\n      "assistance": "test",\n      "prerequisites": [\n        "jugular_fat",\n        "jugular_flat",\n        "jugular_over_artery"\n      ],\n      "pass": {\n        "mastery_percent": 98.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "lung or airway was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 2.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "A choice, below the three of the procedure''s rule."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 30.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 80.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "A choice between the 36 % of residents by free hand and the 90 % with a needle guide (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norms."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 80.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          },\n          {\n            "metric": "time_to_access_s",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "it took too long from skin to vein (s)",\n            "source": "Below one minute from the seventh line on: Intensive Care Med 2014, 40:66, 30 physicians."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 3,\n        "cusum": {\n          "acceptable": 0.1,\n          "unacceptable": 0.4,\n          "limit": 4.07\n        },\n        "lapsesAfter_days": 180,\n        "lapsesAfter": {\n          "failures": 2,\n          "within": 3\n        },\n        "source": "98 % of the standards: the score that experts set where harm counts, Barsuk et al., Acad Med 2018, 93:1079. LC-CUSUM: Biau et al., Br J Surg 2008, 95:925; its limit lets no more than one in ten signal within 50 attempts who fail four in ten. Lapse: after half a year, when one in eight to one in six no longer passed (Barsuk et al., Acad Med 2010, 85:S9). Three in a row, the rates, and two failures of three are choices."\n      }\n    },\n    {\n      "name": "subclavian_first",\n      "title": "First subclavian line",\n      "about": "Below the clavicle with the needle in the plane of the picture, the lung close behind the vein.",\n      "case": "subclavian",\n      "procedure": "subclavian",\n      "position": "Trendelenburg 15",\n      "assistance": "guided",\n      "prerequisites": [\n        "jugular_alone"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the lung was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "nearest_lung_mm",\n            "version": 1,\n            "least": 5.0,\n            "otherwise": "the tip came too near to the lung (mm)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 2.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 15.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "subclavian_alone",\n      "title": "Subclavian line without a guide",\n      "about": "The same chest; nobody says the next step.",\n      "case": "subclavian",\n      "procedure": "subclavian",\n      "position": "Trendelenburg 15",\n      "assistance": "hints",\n      "prerequisites": [\n        "subclavian_first"\n      ],\n      "pass": {\n        "mastery_percent": 88.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the lung was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "nearest_lung_mm",\n            "version": 1,\n            "least": 5.0,\n            "otherwise": "the tip came too near to the lung (mm)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 2.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 15.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "Above the 36 % that residents reached by free hand (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norm."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 40.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 2,\n        "source": "Two in a row: a choice. 88 % of the standards: the least of the published passing scores for jugular lines (Hofstee), Barsuk et al., Acad Med 2018, 93:1079."\n      }\n    },\n    {\n      "name": "subclavian_test",\n      "title": "Subclavian test",\n      "about": "Without hints and without CT. Near the lung there is no second try: three in a row, and again after half a year.",\n      "case": "subclavian",\n      "procedure": "subclavian",\n      "assistance": "test",\n      "prerequisites": [\n        "subclavian_alone",\n        "jugular_test"\n      ],\n      "pass": {\n        "mastery_percent": 98.0,\n        "standards": [\n          {\n            "metric": "artery_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the artery was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "lung_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the lung was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "double_punctures",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the back wall of the vein was punctured",\n            "source": "None is the aim: a complication."\n          },\n          {\n            "metric": "nearest_lung_mm",\n            "version": 1,\n            "least": 5.0,\n            "otherwise": "the tip came too near to the lung (mm)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "used_needle_insertions",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "a used needle was put in again",\n            "source": "None is the aim: asepsis."\n          },\n          {\n            "metric": "passes",\n            "version": 1,\n            "most": 2.0,\n            "otherwise": "there were too many passes through the skin",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "bone_contacts",\n            "version": 1,\n            "most": 0.0,\n            "otherwise": "the needle met bone",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "least": 15.0,\n            "otherwise": "the needle went in too flat (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "insertion_angle_deg",\n            "version": 1,\n            "most": 60.0,\n            "otherwise": "the needle went in too steep (degrees)",\n            "source": "The procedure''s rule."\n          },\n          {\n            "metric": "tip_in_picture_percent",\n            "version": 1,\n            "least": 80.0,\n            "otherwise": "the picture did not show the tip for enough of its way (%)",\n            "source": "A choice between the 36 % of residents by free hand and the 90 % with a needle guide (Ball et al., Br J Anaesth, doi 10.1093/bja/aer329), the procedure''s norms."\n          },\n          {\n            "metric": "aspiration_while_advancing_percent",\n            "version": 1,\n            "least": 80.0,\n            "otherwise": "the syringe was not drawn on for enough of the way (%)",\n            "source": "An aim, not a measurement: drawing all the way tells the vein at once."\n          }\n        ]\n      },\n      "mastery": {\n        "passesInARow": 3,\n        "cusum": {\n          "acceptable": 0.1,\n          "unacceptable": 0.4,\n          "limit": 4.07\n        },\n        "lapsesAfter_days": 180,\n        "lapsesAfter": {\n          "failures": 2,\n          "within": 3\n        },\n        "source": "98 % of the standards: the score that experts set where harm counts, Barsuk et al., Acad Med 2018, 93:1079. LC-CUSUM: Biau et al., Br J Surg 2008, 95:925; its limit lets no more than one in ten signal within 50 attempts who fail four in ten. Lapse: after half a year, when one in eight to one in six no longer passed (Barsuk et al., Acad Med 2010, 85:S9). Three in a row, the rates, and two failures of three are choices."\n      }\n    }\n  ]\n}\n','\n',char(10)),'b9d3b91b7561a91b7c728ec186670977f164963ccaa3bed605af6ac0b1607ae8',1795364392114361,'Dr ina');
CREATE TABLE drafts (
  name TEXT NOT NULL PRIMARY KEY,
  text TEXT NOT NULL
) STRICT;
CREATE TABLE runs (
  id TEXT NOT NULL PRIMARY KEY,
  workstation TEXT NOT NULL,
  machine TEXT NOT NULL,
  boot TEXT NOT NULL,
  pid INTEGER NOT NULL,
  started INTEGER NOT NULL
) STRICT;
INSERT INTO runs VALUES('c9ac0181-7ddf-4b26-8577-c33279bffb09','ward 7','00000000000000000000000000000000','00000000-0000-0000-0000-000000000000',29554,505954);
CREATE TABLE attempts (
  arrival INTEGER NOT NULL PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK (length(id) = 36),
  person TEXT NOT NULL REFERENCES people (id),
  run TEXT NOT NULL,
  curriculum TEXT NOT NULL,
  curriculum_version INTEGER NOT NULL,
  level TEXT NOT NULL,
  procedure TEXT NOT NULL,
  procedure_version INTEGER NOT NULL,
  case_name TEXT NOT NULL,
  case_hash TEXT NOT NULL,
  workstation TEXT NOT NULL,
  begun_us INTEGER NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('open', 'completed', 'abandoned')),
  crashed INTEGER NOT NULL CHECK (crashed IN (0, 1)),
  length_us INTEGER NOT NULL CHECK (length_us >= 0),
  succeeded INTEGER NOT NULL CHECK (succeeded IN (0, 1)),
  critical_errors INTEGER NOT NULL CHECK (critical_errors >= 0),
  points REAL CHECK (points BETWEEN 0 AND 100),
  metrics TEXT NOT NULL,
  recording TEXT NOT NULL,
  recording_hash TEXT NOT NULL,
  voided_us INTEGER,
  voided_by TEXT,
  void_reason TEXT, sitting TEXT NOT NULL DEFAULT 'earlier'
  CHECK (sitting IN ('none', 'earlier', 'opened', 'self', 'practice', 'undecided')),
  CHECK (crashed = 0 OR state = 'abandoned'),
  CHECK (voided_us IS NULL OR state <> 'open')
) STRICT;
INSERT INTO attempts VALUES(1,'f2e5b4ac-75ce-478d-bceb-d6b9f2086ed2','03a421d2-5528-4e5e-9242-ebc9dca3aa48','c9ac0181-7ddf-4b26-8577-c33279bffb09','central_line',2,'first','internal_jugular',1,'neck','0123456789abcdef','ward 7',1795305600000000,'completed',0,62000001,1,1,81.250000000000099477,'[["vein_punctures",1,1.0],["time_to_vein_s",2,0.30000000000000004],["near_miss_mm",1,null]]','2026-11-22.rec','aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa',NULL,NULL,NULL,'earlier');
INSERT INTO attempts VALUES(2,'cb18361b-e409-4473-a598-a5ffab27c33b','03a421d2-5528-4e5e-9242-ebc9dca3aa48','c9ac0181-7ddf-4b26-8577-c33279bffb09','central_line',2,'first','internal_jugular',1,'neck','0123456789abcdef','ward 7',1795305600000000,'completed',0,62000001,1,1,81.250000000000099477,'[["vein_punctures",1,1.0],["time_to_vein_s",2,0.30000000000000004],["near_miss_mm",1,null]]','2026-11-22.rec','aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa',1795364392095318,'f88474d0-4839-4930-8827-26b3911be7d3','device failed','earlier');
CREATE TABLE forms (
  arrival INTEGER NOT NULL PRIMARY KEY,
  id TEXT NOT NULL UNIQUE CHECK (length(id) = 36),
  form TEXT NOT NULL,
  form_version INTEGER NOT NULL,
  person TEXT NOT NULL REFERENCES people (id),
  attempt TEXT REFERENCES attempts (id),
  filled_by TEXT NOT NULL REFERENCES people (id),
  filled_us INTEGER NOT NULL,
  answers TEXT NOT NULL
) STRICT;
INSERT INTO forms VALUES(1,'fde84dc9-3634-4e01-8c26-34ebf2ebbe08','feedback',1,'03a421d2-5528-4e5e-9242-ebc9dca3aa48','f2e5b4ac-75ce-478d-bceb-d6b9f2086ed2','03a421d2-5528-4e5e-9242-ebc9dca3aa48',1795364392110998,'{"realism": 4}');
CREATE TABLE outbox (
  number INTEGER NOT NULL PRIMARY KEY,
  kind TEXT NOT NULL CHECK (kind IN ('attempt', 'form', 'password')),
  id TEXT NOT NULL,
  since_us INTEGER NOT NULL,
  UNIQUE (kind, id)
) STRICT;
INSERT INTO outbox VALUES(1,'password','f88474d0-4839-4930-8827-26b3911be7d3',1795364391795206);
INSERT INTO outbox VALUES(2,'password','3a0500d2-61df-4ad6-b315-0c47d24f0c49',1795364391835133);
INSERT INTO outbox VALUES(3,'password','03a421d2-5528-4e5e-9242-ebc9dca3aa48',1795364391907392);
INSERT INTO outbox VALUES(4,'password','cb19eef1-2e68-438e-94b8-27cfbc4ba9a7',1795364391953665);
INSERT INTO outbox VALUES(5,'password','874ec70e-fc1d-4a61-bfae-2327ffac9b23',1795364392017505);
INSERT INTO outbox VALUES(7,'attempt','f2e5b4ac-75ce-478d-bceb-d6b9f2086ed2',1795364392079501);
INSERT INTO outbox VALUES(10,'attempt','cb18361b-e409-4473-a598-a5ffab27c33b',1795364392095399);
INSERT INTO outbox VALUES(11,'form','fde84dc9-3634-4e01-8c26-34ebf2ebbe08',1795364392111309);
CREATE TABLE site (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  outbox_number INTEGER NOT NULL,
  server TEXT NOT NULL
) STRICT;
INSERT INTO site VALUES(1,11,'');
CREATE TABLE audit (
  number INTEGER NOT NULL PRIMARY KEY,
  time_us INTEGER NOT NULL,
  actor TEXT NOT NULL,
  workstation TEXT NOT NULL,
  act TEXT NOT NULL,
  person TEXT NOT NULL,
  detail TEXT NOT NULL,
  allowed INTEGER NOT NULL CHECK (allowed IN (0, 1)),
  hash TEXT NOT NULL CHECK (length(hash) = 64)
) STRICT;
INSERT INTO audit VALUES(1,1795364391735490,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','create first administrator','8170ddc4-af03-4e39-b267-e0410f16454f','',1,'323d9b442d9a8580c0757361f81d6a4cbf5e3cd44f507c06f05778d61285c75e');
INSERT INTO audit VALUES(2,1795364391747141,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','change cohorts','','add',1,'a9d52de3ea359ad1c2e8e0adec6fd52f4761fcdda167adbd5065e91aade84bd0');
INSERT INTO audit VALUES(3,1795364391755163,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','change cohorts','','add',1,'f775de49394c22e792ce0298f80f63afd8a5dc9f8fe2616ce95270cbae79b61e');
INSERT INTO audit VALUES(4,1795364391763114,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','add person','','ina, instructor, cohort 551a7610-87a8-4f8d-abc5-699a11eb1587',1,'2305c186608df94949a241fb1782e808c83668fd940b8de2d9bb0ea83d998398');
INSERT INTO audit VALUES(5,1795364391783437,'f88474d0-4839-4930-8827-26b3911be7d3','ward 7','sign in','f88474d0-4839-4930-8827-26b3911be7d3','',1,'ea7bff8dfac0e2d16cb7a3757ae7cf30abe45b82fde69603c499d98fcedf7c1c');
INSERT INTO audit VALUES(6,1795364391787075,'f88474d0-4839-4930-8827-26b3911be7d3','ward 7','sign in','f88474d0-4839-4930-8827-26b3911be7d3','',1,'06adc755f45d41cdde8414c495428cd60058acc12b82e3bbb4a2fb8a342e2dec');
INSERT INTO audit VALUES(7,1795364391807114,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','add person','','otto, instructor, cohort c66013b6-0b6f-49ab-a403-a5091618bcc3',1,'6ee2e2b5b6a53b41ac679b34c70d94903a928e71d62fcf5a92ecbc0f4ec64030');
INSERT INTO audit VALUES(8,1795364391817448,'3a0500d2-61df-4ad6-b315-0c47d24f0c49','ward 7','sign in','3a0500d2-61df-4ad6-b315-0c47d24f0c49','',1,'8e2297e10d803d5179b104b80301ebd25d986f403db2afb74b925136de9737b0');
INSERT INTO audit VALUES(9,1795364391823089,'3a0500d2-61df-4ad6-b315-0c47d24f0c49','ward 7','sign in','3a0500d2-61df-4ad6-b315-0c47d24f0c49','',1,'b2a0bb258e2117c05c09a8b8a79d46d03ad969287a2bf67983fc6917648c4cd6');
INSERT INTO audit VALUES(10,1795364391847107,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','add trainee','','anna, trainee, cohort 551a7610-87a8-4f8d-abc5-699a11eb1587',1,'1c79a62c1543926655d838be9859af3621f6af7db21ef26c329ed65042eb4302');
INSERT INTO audit VALUES(11,1795364391867189,'03a421d2-5528-4e5e-9242-ebc9dca3aa48','ward 7','sign in','03a421d2-5528-4e5e-9242-ebc9dca3aa48','',1,'c584f8bae25309b87bee72b31a0cf62fc3a8648e132367a4a63eb291a4d30d1d');
INSERT INTO audit VALUES(12,1795364391895161,'03a421d2-5528-4e5e-9242-ebc9dca3aa48','ward 7','sign in','03a421d2-5528-4e5e-9242-ebc9dca3aa48','',1,'8f0d6ab30ea169d896b5a864f1c848423c2182693c46051aaac8816fe3a64521');
INSERT INTO audit VALUES(13,1795364391909072,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','add trainee','','ben, trainee, cohort 551a7610-87a8-4f8d-abc5-699a11eb1587',1,'5b1ed4e8c02c1124035f0ccca7a1508a8d8c58c117cf10bbf88905ce59648bab');
INSERT INTO audit VALUES(14,1795364391927070,'cb19eef1-2e68-438e-94b8-27cfbc4ba9a7','ward 7','sign in','cb19eef1-2e68-438e-94b8-27cfbc4ba9a7','',1,'9a69b6f603b32dce51f52a406403602be64a584362bfa27ed70a52c587cd79dd');
INSERT INTO audit VALUES(15,1795364391952081,'cb19eef1-2e68-438e-94b8-27cfbc4ba9a7','ward 7','sign in','cb19eef1-2e68-438e-94b8-27cfbc4ba9a7','',1,'71157bad5cca0c626066b82a8410ffea2633b155c49f93c5f44495a0b620f707');
INSERT INTO audit VALUES(16,1795364391955771,'8170ddc4-af03-4e39-b267-e0410f16454f','ward 7','add trainee','','carl, trainee, cohort c66013b6-0b6f-49ab-a403-a5091618bcc3',1,'68e4563b2311437e29a72d2d4373e3d63c38bfeb1156a082d611c5f4d5ef82da');
INSERT INTO audit VALUES(17,1795364391983110,'874ec70e-fc1d-4a61-bfae-2327ffac9b23','ward 7','sign in','874ec70e-fc1d-4a61-bfae-2327ffac9b23','',1,'0a2456bda58b1b59affdc674546233d5c35e0b25156483a4787b06ef091fae10');
INSERT INTO audit VALUES(18,1795364392003077,'874ec70e-fc1d-4a61-bfae-2327ffac9b23','ward 7','sign in','874ec70e-fc1d-4a61-bfae-2327ffac9b23','',1,'27b244a2e3b74ca24c943a11fbaf997d1a5d981df931d3f5f2ecf4e1156db12b');
INSERT INTO audit VALUES(19,1795364392029054,'03a421d2-5528-4e5e-9242-ebc9dca3aa48','ward 7','sign in','03a421d2-5528-4e5e-9242-ebc9dca3aa48','',1,'e445d8bf5db26f122f86f6843a060b4eea03c9d9c3b4bf90c867d2d1d1b1521e');
INSERT INTO audit VALUES(20,1795364392055164,'f88474d0-4839-4930-8827-26b3911be7d3','ward 7','sign in','f88474d0-4839-4930-8827-26b3911be7d3','',1,'f8a09817cfc650f127c0b7da5acbaa1c03ef01fc9ee2defec731a9c5711261b5');
INSERT INTO audit VALUES(21,1795364392095224,'f88474d0-4839-4930-8827-26b3911be7d3','ward 7','void attempt','03a421d2-5528-4e5e-9242-ebc9dca3aa48','device failed, attempt cb18361b-e409-4473-a598-a5ffab27c33b',1,'1cafbc8982bb4ddc5f397fafcd9b79ce40b24bc2b3eb80b9fbd48f5b90c9580f');
INSERT INTO audit VALUES(22,1795364392114438,'f88474d0-4839-4930-8827-26b3911be7d3','ward 7','publish curriculum','','central_line 1',1,'a9f8765cb79831639d9195a473e6e4c5cf572bdf74dfd368f41489bbd2eb2466');
INSERT INTO audit VALUES(23,1795364392127135,'f88474d0-4839-4930-8827-26b3911be7d3','ward 7','set curriculum','','central_line 1, cohort 551a7610-87a8-4f8d-abc5-699a11eb1587',1,'7530eb7ae51d78da6e8100cae7d0906df982cfadfc38669a92046ec5dfb37b1b');
INSERT INTO audit VALUES(24,1795387273346779,'8170ddc4-af03-4e39-b267-e0410f16454f','vm','sign in','8170ddc4-af03-4e39-b267-e0410f16454f','',1,'dea79d2370a54cc091a7db21150b67d32f5fb2e5b0a4e6e91ccd08fd770de0c1');
INSERT INTO audit VALUES(25,1795387273351235,'8170ddc4-af03-4e39-b267-e0410f16454f','vm','look after store','','facts',1,'3336046e3504ea2007de3fd3e35692a8b3c044f7fbd6fc2b75685d3d663a7358');
INSERT INTO audit VALUES(26,1795387273443183,'f88474d0-4839-4930-8827-26b3911be7d3','vm','sign in','f88474d0-4839-4930-8827-26b3911be7d3','',1,'9a8462852ba2506123cd7f40690fc5842754112a4ae8d2c9a3bc25f3d9ac40e5');
INSERT INTO audit VALUES(27,1795387273447289,'f88474d0-4839-4930-8827-26b3911be7d3','vm','see members','','cohort 551a7610-87a8-4f8d-abc5-699a11eb1587, learners 2',1,'5a0cc2939ac10942be6399edbf2b31c0d11aff69d62c1b8eb12d517048420ccb');
INSERT INTO audit VALUES(28,1795387273451066,'f88474d0-4839-4930-8827-26b3911be7d3','vm','see standings','','people 03a421d2-5528-4e5e-9242-ebc9dca3aa48 cb19eef1-2e68-438e-94b8-27cfbc4ba9a7, cohort 551a7610-87a8-4f8d-abc5-699a11eb1587',1,'1b8cc15581b600fbe7d8d1b11364e5777eaba44f8ed95b6addb1998ef0e194d5');
CREATE TABLE audit_end (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  number INTEGER NOT NULL,
  hash TEXT NOT NULL
) STRICT;
INSERT INTO audit_end VALUES(1,28,'1b8cc15581b600fbe7d8d1b11364e5777eaba44f8ed95b6addb1998ef0e194d5');
CREATE TABLE standings (
  person TEXT NOT NULL REFERENCES people (id),
  curriculum TEXT NOT NULL,
  curriculum_version INTEGER NOT NULL,
  level TEXT NOT NULL,
  mastered INTEGER NOT NULL,
  concern TEXT NOT NULL,
  sentence TEXT NOT NULL,
  changes INTEGER NOT NULL,
  from_us INTEGER NOT NULL,
  until_us INTEGER NOT NULL,
  rules INTEGER NOT NULL,
  PRIMARY KEY (person, curriculum, curriculum_version)
) STRICT;
INSERT INTO standings VALUES('03a421d2-5528-4e5e-9242-ebc9dca3aa48','central_line',1,'jugular_first',0,'','Open: no attempt counts yet; 2 passes in a row master it.',5,1795387273451006,9223372036854775807,1);
INSERT INTO standings VALUES('cb19eef1-2e68-438e-94b8-27cfbc4ba9a7','central_line',1,'jugular_first',0,'','Open: no attempt counts yet; 2 passes in a row master it.',0,1795387273451006,9223372036854775807,1);
CREATE TABLE hands (
  hash TEXT NOT NULL PRIMARY KEY CHECK (length(hash) = 64),
  attempt TEXT NOT NULL REFERENCES attempts (id),
  since_us INTEGER NOT NULL
) STRICT;
INSERT INTO hands VALUES('dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd','f2e5b4ac-75ce-478d-bceb-d6b9f2086ed2',1795305662000001);
CREATE TABLE store_secret (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  secret TEXT NOT NULL CHECK (length(secret) = 64)
) STRICT;
INSERT INTO store_secret VALUES(1,'76cb08ce0307e2dfc28b3208d4c1694b17d32f8a30b44a8a130bdcf91f92ac0d');
CREATE TABLE proofs (
  attempt TEXT NOT NULL PRIMARY KEY REFERENCES attempts (id),
  state TEXT NOT NULL CHECK (state IN ('unproven', 'proven', 'accepted', 'earlier', 'demonstration')),
  accepted_by TEXT NOT NULL,
  CHECK ((state = 'accepted') = (accepted_by <> ''))
) STRICT;
INSERT INTO proofs VALUES('f2e5b4ac-75ce-478d-bceb-d6b9f2086ed2','earlier','');
INSERT INTO proofs VALUES('cb18361b-e409-4473-a598-a5ffab27c33b','earlier','');
CREATE TABLE sign_in_tokens (
  hash TEXT NOT NULL PRIMARY KEY CHECK (length(hash) = 64),
  person TEXT NOT NULL REFERENCES people (id),
  version INTEGER NOT NULL,
  made_us INTEGER NOT NULL
) STRICT;
CREATE TABLE comments (
  id TEXT NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  attempt TEXT NOT NULL REFERENCES attempts (id),
  at_us INTEGER NOT NULL CHECK (at_us >= 0),
  author TEXT NOT NULL,
  written_us INTEGER NOT NULL,
  text TEXT NOT NULL,
  read_us INTEGER,
  removed_us INTEGER,
  removed_by TEXT,
  CHECK ((removed_us IS NULL) = (removed_by IS NULL)),
  CHECK ((removed_us IS NULL) = (text <> ''))
) STRICT;
INSERT INTO comments VALUES('5b0e7f3e-7d1c-4a52-9c39-0c2f6a1d9b11','f2e5b4ac-75ce-478d-bceb-d6b9f2086ed2',3000000,'f88474d0-4839-4930-8827-26b3911be7d3',1795700001000000,'Withdraw first',NULL,NULL,NULL);
CREATE TABLE browser_sessions (
  hash TEXT NOT NULL PRIMARY KEY CHECK (length(hash) = 64),
  person TEXT NOT NULL REFERENCES people (id),
  version INTEGER NOT NULL,
  begun_us INTEGER NOT NULL,
  used_us INTEGER NOT NULL
) STRICT;
CREATE TABLE openings (
  id TEXT NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  cohort TEXT NOT NULL,
  curriculum TEXT NOT NULL,
  level TEXT NOT NULL,
  start_us INTEGER NOT NULL,
  end_us INTEGER,
  code TEXT NOT NULL,
  opened_by TEXT NOT NULL,
  opened_us INTEGER NOT NULL,
  closed_by TEXT,
  closed_us INTEGER,
  CHECK (end_us IS NULL OR end_us > start_us),
  CHECK (end_us IS NOT NULL OR code <> ''),
  CHECK ((closed_us IS NULL) = (closed_by IS NULL))
) STRICT;
CREATE TABLE opening_entries (
  opening TEXT NOT NULL REFERENCES openings (id),
  person TEXT NOT NULL REFERENCES people (id),
  entered_us INTEGER NOT NULL,
  PRIMARY KEY (opening, person)
) STRICT;
CREATE TABLE workstations (
  name TEXT NOT NULL PRIMARY KEY,
  token_hash TEXT NOT NULL UNIQUE CHECK (length(token_hash) = 64),
  added_by TEXT NOT NULL REFERENCES people (id),
  added_us INTEGER NOT NULL,
  seen_us INTEGER,
  revoked_us INTEGER,
  store_secret TEXT NOT NULL CHECK (length(store_secret) IN (0, 64))
) STRICT;
CREATE TABLE workstation_people (
  workstation TEXT NOT NULL REFERENCES workstations (name),
  person TEXT NOT NULL REFERENCES people (id),
  since_us INTEGER NOT NULL,
  PRIMARY KEY (workstation, person)
) STRICT;
CREATE TABLE verifications (
  attempt TEXT NOT NULL PRIMARY KEY REFERENCES attempts (id),
  since_us INTEGER NOT NULL,
  received_us INTEGER,
  taken_us INTEGER,
  ended_us INTEGER,
  why TEXT NOT NULL
) STRICT;
CREATE TABLE videos (
  attempt TEXT NOT NULL PRIMARY KEY REFERENCES attempts (id),
  asked_us INTEGER NOT NULL,
  begun_us INTEGER,
  taken_us INTEGER,
  taken_by TEXT NOT NULL,
  permille INTEGER NOT NULL,
  ended_us INTEGER,
  why TEXT NOT NULL
, tries INTEGER NOT NULL DEFAULT 0) STRICT;
CREATE TABLE erasures (
  person TEXT NOT NULL PRIMARY KEY REFERENCES people (id),
  erased_us INTEGER NOT NULL,
  erased_by TEXT NOT NULL
) STRICT;
CREATE TABLE retention (
  one INTEGER NOT NULL PRIMARY KEY CHECK (one = 1),
  erase_months INTEGER CHECK (erase_months > 0),
  recording_months INTEGER CHECK (recording_months > 0),
  set_us INTEGER NOT NULL,
  waits_us INTEGER NOT NULL,
  applied_us INTEGER NOT NULL
) STRICT;
INSERT INTO retention VALUES(1,NULL,NULL,0,0,0);
CREATE INDEX memberships_by_person ON memberships (person, teaches, cohort);
CREATE INDEX attempts_by_person ON attempts (person, arrival, state, crashed, voided_us, begun_us, level);
CREATE INDEX attempts_open ON attempts (run) WHERE state = 'open';
CREATE INDEX forms_by_person ON forms (person, arrival);
CREATE INDEX forms_by_attempt ON forms (attempt, arrival);
CREATE INDEX audit_by_actor ON audit (actor, number);
CREATE INDEX audit_by_person ON audit (person, number);
CREATE TRIGGER attempts_stay BEFORE DELETE ON attempts
BEGIN
  SELECT RAISE(ABORT, 'An attempt is not deleted: void it.');
END;
CREATE TRIGGER attempts_come_once BEFORE INSERT ON attempts
WHEN EXISTS (SELECT 1 FROM attempts WHERE id = NEW.id OR arrival = NEW.arrival)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: attempts.');
END;
CREATE TRIGGER forms_stay BEFORE DELETE ON forms
BEGIN
  SELECT RAISE(ABORT, 'A form that was filled in is not deleted.');
END;
CREATE TRIGGER forms_come_once BEFORE INSERT ON forms
WHEN EXISTS (SELECT 1 FROM forms WHERE id = NEW.id OR arrival = NEW.arrival)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: forms.');
END;
CREATE TRIGGER curricula_stay BEFORE DELETE ON curricula
BEGIN
  SELECT RAISE(ABORT, 'A published curriculum is not deleted.');
END;
CREATE TRIGGER curricula_come_once BEFORE INSERT ON curricula
WHEN EXISTS (SELECT 1 FROM curricula WHERE name = NEW.name AND version = NEW.version)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: curricula.');
END;
CREATE TRIGGER audit_stay BEFORE DELETE ON audit
BEGIN
  SELECT RAISE(ABORT, 'The audit log is not shortened.');
END;
CREATE TRIGGER audit_come_once BEFORE INSERT ON audit
WHEN EXISTS (SELECT 1 FROM audit WHERE number = NEW.number)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: audit.');
END;
CREATE TRIGGER curricula_fixed BEFORE UPDATE ON curricula
BEGIN
  SELECT RAISE(ABORT, 'A published curriculum is not changed: publish another version.');
END;
CREATE INDEX attempts_by_recording_hash ON attempts (recording_hash);
CREATE INDEX attempts_by_recording ON attempts (workstation, recording, arrival);
CREATE INDEX hands_by_attempt ON hands (attempt);
CREATE TRIGGER hands_stay BEFORE DELETE ON hands
BEGIN
  SELECT RAISE(ABORT, 'A recording that was counted stays counted.');
END;
CREATE TRIGGER hands_come_once BEFORE INSERT ON hands
WHEN EXISTS (SELECT 1 FROM hands WHERE hash = NEW.hash)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: hands.');
END;
CREATE TRIGGER hands_fixed BEFORE UPDATE ON hands
BEGIN
  SELECT RAISE(ABORT, 'A recording that was counted stays counted.');
END;
CREATE TRIGGER store_secret_stays BEFORE DELETE ON store_secret
BEGIN
  SELECT RAISE(ABORT, 'The secret of the store stays as it is.');
END;
CREATE TRIGGER store_secret_comes_once BEFORE INSERT ON store_secret
WHEN EXISTS (SELECT 1 FROM store_secret)
BEGIN
  SELECT RAISE(ABORT, 'The secret of the store stays as it is.');
END;
CREATE TRIGGER store_secret_fixed BEFORE UPDATE ON store_secret
BEGIN
  SELECT RAISE(ABORT, 'The secret of the store stays as it is.');
END;
CREATE TRIGGER proofs_stay BEFORE DELETE ON proofs
BEGIN
  SELECT RAISE(ABORT, 'The proof of an attempt stays as it is.');
END;
CREATE TRIGGER proofs_come_once BEFORE INSERT ON proofs
WHEN EXISTS (SELECT 1 FROM proofs WHERE attempt = NEW.attempt)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: proofs.');
END;
CREATE INDEX attempts_by_length ON attempts (length_us);
CREATE INDEX sign_in_tokens_by_person ON sign_in_tokens (person);
CREATE INDEX comments_by_attempt ON comments (attempt, at_us);
CREATE TRIGGER comments_stay BEFORE DELETE ON comments
BEGIN
  SELECT RAISE(ABORT, 'A comment stays, with or without its text.');
END;
CREATE TRIGGER comments_come_once BEFORE INSERT ON comments
WHEN EXISTS (SELECT 1 FROM comments WHERE id = NEW.id)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: comments.');
END;
CREATE TRIGGER comments_fixed BEFORE UPDATE ON comments
WHEN NOT (NEW.id = OLD.id AND NEW.attempt = OLD.attempt AND NEW.at_us = OLD.at_us AND NEW.author = OLD.author
  AND NEW.written_us = OLD.written_us AND OLD.removed_us IS NULL
  AND (OLD.read_us IS NULL OR COALESCE(NEW.read_us, -1) = OLD.read_us)
  AND (NEW.text = OLD.text OR NEW.removed_us IS NOT NULL))
BEGIN
  SELECT RAISE(ABORT, 'A comment can be read and removed, but not changed.');
END;
CREATE INDEX browser_sessions_by_person ON browser_sessions (person);
CREATE INDEX openings_by_level ON openings (curriculum, level);
CREATE TRIGGER openings_stay BEFORE DELETE ON openings
BEGIN
  SELECT RAISE(ABORT, 'An opening of a test is not deleted: close it.');
END;
CREATE TRIGGER openings_come_once BEFORE INSERT ON openings
WHEN EXISTS (SELECT 1 FROM openings WHERE id = NEW.id)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: openings.');
END;
CREATE TRIGGER openings_fixed BEFORE UPDATE ON openings
WHEN (NEW.id, NEW.cohort, NEW.curriculum, NEW.level, NEW.start_us, NEW.end_us, NEW.code, NEW.opened_by, NEW.opened_us)
  IS NOT (OLD.id, OLD.cohort, OLD.curriculum, OLD.level, OLD.start_us, OLD.end_us, OLD.code, OLD.opened_by,
  OLD.opened_us) OR OLD.closed_us IS NOT NULL
BEGIN
  SELECT RAISE(ABORT, 'An opening of a test can be closed, once, but not changed.');
END;
CREATE TRIGGER opening_entries_stay BEFORE DELETE ON opening_entries
BEGIN
  SELECT RAISE(ABORT, 'A code that was entered stays entered.');
END;
CREATE TRIGGER opening_entries_come_once BEFORE INSERT ON opening_entries
WHEN EXISTS (SELECT 1 FROM opening_entries WHERE opening = NEW.opening AND person = NEW.person)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: opening_entries.');
END;
CREATE TRIGGER opening_entries_fixed BEFORE UPDATE ON opening_entries
BEGIN
  SELECT RAISE(ABORT, 'A code that was entered stays entered.');
END;
CREATE TRIGGER attempts_sitting_fixed BEFORE UPDATE ON attempts
WHEN NEW.sitting IS NOT OLD.sitting AND OLD.sitting <> 'undecided'
BEGIN
  SELECT RAISE(ABORT, 'Whether a test was open for an attempt is decided once.');
END;
CREATE INDEX verifications_that_wait ON verifications (ended_us, received_us);
CREATE TRIGGER proofs_fixed BEFORE UPDATE ON proofs
WHEN NOT (NEW.attempt = OLD.attempt AND ((OLD.state = 'unproven' AND NEW.state = 'accepted')
  OR (OLD.state = 'proven' AND NEW.state = 'unproven' AND EXISTS (SELECT 1 FROM site WHERE server LIKE 'http%'))))
BEGIN
  SELECT RAISE(ABORT, 'The proof of an attempt stays as it is.');
END;
CREATE INDEX videos_that_wait ON videos (ended_us, asked_us);
CREATE TRIGGER erasures_stay BEFORE DELETE ON erasures
BEGIN
  SELECT RAISE(ABORT, 'A person who was erased stays erased.');
END;
CREATE TRIGGER erasures_come_once BEFORE INSERT ON erasures
WHEN EXISTS (SELECT 1 FROM erasures WHERE person = NEW.person)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: erasures.');
END;
CREATE TRIGGER erasures_fixed BEFORE UPDATE ON erasures
BEGIN
  SELECT RAISE(ABORT, 'A person who was erased stays erased.');
END;
CREATE TRIGGER audit_fixed BEFORE UPDATE ON audit
WHEN NOT ((NEW.number, NEW.time_us, NEW.actor, NEW.workstation, NEW.act, NEW.person, NEW.allowed, NEW.hash) IS
  (OLD.number, OLD.time_us, OLD.actor, OLD.workstation, OLD.act, OLD.person, OLD.allowed, OLD.hash)
  AND NEW.detail LIKE '(erased)%')
BEGIN
  SELECT RAISE(ABORT, 'The audit log is not changed.');
END;
CREATE TRIGGER forms_fixed BEFORE UPDATE ON forms
WHEN NOT ((NEW.arrival, NEW.id, NEW.form, NEW.form_version, NEW.person, NEW.attempt, NEW.filled_by, NEW.filled_us) IS
  (OLD.arrival, OLD.id, OLD.form, OLD.form_version, OLD.person, OLD.attempt, OLD.filled_by, OLD.filled_us)
  AND EXISTS (SELECT 1 FROM erasures WHERE erasures.person = OLD.person))
BEGIN
  SELECT RAISE(ABORT, 'A form that was filled in is not changed: fill in another.');
END;
CREATE TRIGGER attempts_fixed BEFORE UPDATE ON attempts
WHEN
    (NEW.id, NEW.person, NEW.run, NEW.curriculum, NEW.curriculum_version, NEW.level, NEW.procedure,
    NEW.procedure_version, NEW.case_name, NEW.case_hash, NEW.workstation, NEW.begun_us, NEW.arrival) IS NOT
    (OLD.id, OLD.person, OLD.run, OLD.curriculum, OLD.curriculum_version, OLD.level, OLD.procedure,
    OLD.procedure_version, OLD.case_name, OLD.case_hash, OLD.workstation, OLD.begun_us, OLD.arrival)
  OR (
    (NEW.state, NEW.crashed, NEW.length_us, NEW.succeeded, NEW.critical_errors, NEW.points, NEW.metrics,
    NEW.recording_hash) IS NOT (OLD.state, OLD.crashed, OLD.length_us, OLD.succeeded,
    OLD.critical_errors, OLD.points, OLD.metrics, OLD.recording_hash)
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (
    (NEW.voided_us, NEW.voided_by) IS NOT (OLD.voided_us, OLD.voided_by)
    AND OLD.voided_us IS NOT NULL)
BEGIN
  SELECT RAISE(ABORT, 'An attempt is not changed once it has ended: void it.');
END;
CREATE TRIGGER attempts_texts_fixed BEFORE UPDATE ON attempts
WHEN (
    (NEW.recording IS NOT OLD.recording
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (NEW.void_reason IS NOT OLD.void_reason AND OLD.voided_us IS NOT NULL))
  AND NOT (EXISTS (SELECT 1 FROM erasures WHERE erasures.person = OLD.person)
  AND NEW.recording IN (OLD.recording, '')
  AND COALESCE(NEW.void_reason, '') IN (COALESCE(OLD.void_reason, ''), '(erased)'))
BEGIN
  SELECT RAISE(ABORT, 'An attempt is not changed once it has ended: void it.');
END;
COMMIT;
