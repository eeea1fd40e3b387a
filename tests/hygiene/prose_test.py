"""The pages and the comments of schema and sources read easily: short sentences, none with a clause as its subject."""
import re
import unittest

import house
import prose

MOST_WORDS = 25
CLAUSE = re.compile(r"(Who|Whoever|What|Whatever|That which)\b(?!.*\?$)")


def fault(sentence):
    """What is wrong with a sentence, or None."""
    count = prose.words(sentence)
    if count > MOST_WORDS:
        return f"{count} words"
    if CLAUSE.match(sentence):
        return "a clause as subject"
    return None


def faults(files, paragraphs_of):
    found = []
    for file in files:
        for paragraph in paragraphs_of(house.text(file)):
            for sentence in prose.sentences(paragraph):
                if fault(sentence):
                    found.append(f"{file}: {fault(sentence)}: {sentence}")
    return found


class Prose(unittest.TestCase):
    maxDiff = None

    def test_the_rule_itself(self):
        self.assertIsNone(fault(" ".join(["word"] * 25) + "."))
        self.assertIsNotNone(fault(" ".join(["word"] * 26) + "."))
        self.assertIsNotNone(fault("Who is taken off the list gets no answer."))
        self.assertIsNone(fault("What is a feed?"))
        self.assertEqual(prose.sentences("It is 1.5 long. `x. y` ends. So."), ["It is 1.5 long.", "CODE ends.", "So."])
        page = "# Title\n\nOne\nline. [Two](a.md).\n\n    code\n\n- item\n- other\n\n| a | b |\n"
        self.assertEqual(prose.paragraphs_of_page(page), ["One line. Two.", "item", "other"])
        schema = "// Above\n// it.\nmessage A {\n  int32 a = 1;  // beside\n  // below\n}\n"
        self.assertEqual(prose.paragraphs_of_schema(schema), ["Above it.", "beside", "below"])
        source = "// Above:\n// - item\n//   a = b\n// below.\nint a;  // beside\n"
        self.assertEqual(prose.paragraphs_of_source(source), ["Above:", "below.", "beside"])

    def test_pages(self):
        self.assertGreater(len(prose.pages()), 5)
        self.assertEqual(faults(prose.pages(), prose.paragraphs_of_page), [])

    def test_no_page_names_what_readers_do_not_have(self):
        self.assertEqual([page for page in prose.pages() if "DESIGN" in house.text(page)], [])

    def test_schema(self):
        self.assertEqual(len(prose.schemas()), 8)
        self.assertEqual(faults(prose.schemas(), prose.paragraphs_of_schema), [])

    def test_sources(self):
        self.assertGreater(len(prose.sources()), 1000)
        self.assertEqual(faults(prose.sources(), prose.paragraphs_of_source), [])


if __name__ == "__main__":
    unittest.main()
