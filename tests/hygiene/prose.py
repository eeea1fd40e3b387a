"""The sentences of the pages, and of the comments of schema and sources, for the hygiene tests."""
import re

import house


def pages():
    return [p.as_posix() for p in house.files({".md"})]


def schemas():
    return [p.as_posix() for p in house.files({".proto"}) if p.parts[0] == "proto"]


def without_code(page):
    """A page without its code blocks: fenced, or indented by four after an empty line."""
    page = re.sub(r"^```.*?^```$", "", page, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"(?<=\n\n)(?: {4}.*\n+)+", "\n", page)


def paragraphs_of_page(page):
    """Its paragraphs and list items, without headings, tables and code, each as one line."""
    text = re.sub(r"^(#|\||!\[).*$", "", without_code(page), flags=re.MULTILINE)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)  # a link is its text
    text = re.sub(r"^ *(?:[-*]|\d+\.) +", "\n", text, flags=re.MULTILINE)  # an item is a paragraph
    return [" ".join(item.split()) for item in re.split(r"\n\s*\n", text) if item.strip()]


def paragraphs_of_schema(schema):
    """Its comments: each block of whole lines, and each comment at the end of a line."""
    text = re.sub(r"^ *[^\s/].*?(//.*)$", r"\n\1\n", schema, flags=re.MULTILINE)
    blocks = re.findall(r"(?:^ *//.*\n?)+", text, re.MULTILINE)
    return [" ".join(re.sub(r"^ *// ?", "", block, flags=re.MULTILINE).split()) for block in blocks]


def sources():
    return [p.as_posix() for p in house.files(house.SOURCES)]


def paragraphs_of_source(source):
    """Its comments, without lines that are indented: lists, tables and formulas."""
    return paragraphs_of_schema(re.sub(r"^ *//(?:(?:  | - | ?\S+  ).*)?$", "", source, flags=re.MULTILINE))


def sentences(paragraph):
    """Its sentences; what stands in backticks is one word, and so is a number or path with a point."""
    plain = re.sub(r"`[^`]*`", "CODE", paragraph)
    return [s for s in re.split(r"(?<=[.!?])[)*\"]* +(?=[\W_]*[A-Z0-9])", plain) if s]


def words(sentence):
    return len(re.findall(r"[\w'{}\[\]/^.,:=*+-]*\w[\w'{}\[\]/^.,:=*+-]*", sentence))
