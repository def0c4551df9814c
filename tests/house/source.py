"""Reads C++ as far as the rules need it: which blocks and statements stand at namespace
and class level, where they begin and end, and what they declare."""

import bisect
import collections
import re

# kind: namespace, type, function, value (braces of an initialiser) or statement (no braces).
# level: namespace or type, after the block around it.
Declaration = collections.namedtuple("Declaration", "kind level head first last")

SKIPPED = re.compile(r"""
    //[^\n]* | /\*.*?\*/                                # comments
  | R"(?P<end>[^\s()\\]*)\(.*?\)(?P=end)"               # raw strings
  | "(?:\\.|[^"\\\n])*" | (?<!\w)'(?:\\.|[^'\\\n])*'    # strings and characters, not 1'000
  | ^[ \t]*\#(?:\\\n|[^\n])*                            # the preprocessor's lines
""", re.S | re.M | re.X)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)', re.M)
ACCESS = re.compile(r"^\s*(?:public|protected|private)\s*:(?!:)")
TEMPLATE = re.compile(r"^\s*template\s*<")
TYPE = re.compile(r"^(?:typedef\s+)?(?:struct|class|union|enum)\b")
NAMESPACE = re.compile(r'^(?:inline\s+)?namespace\b|^extern\s*$')
# What may stand between the arguments of a function and its body.
TAIL = re.compile(r"\b(?:const|noexcept|override|final|mutable|try)$")

NOT_NAMES = {"decltype", "alignas", "noexcept", "explicit", "requires", "__attribute__"}
DIRECTIVE = re.compile(r"using\s+namespace\b|using\s+[\w:]+$|static_assert\b|friend\b|extern\b")


def blanked(text):
    """The text with spaces for comments, strings and preprocessor lines; every line stays in place."""
    return SKIPPED.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def includes(text):
    """Line, opening sign and path of every include."""
    return [(text.count("\n", 0, found.start()) + 1, found.group(1), found.group(2))
            for found in INCLUDE.finditer(text)]


def after_angles(text, start):
    """Where the list that opens with the '<' at start ends."""
    depth = 0
    for place in range(start, len(text)):
        depth += {"<": 1, ">": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    return len(text)


def stripped(head):
    """The head without access specifiers, attributes and template lists, and how much was cut in front."""
    place = 0
    while True:
        rest = head[place:]
        if found := ACCESS.match(rest):
            place += found.end()
        elif found := TEMPLATE.match(rest):
            place += after_angles(rest, found.end() - 1)
        elif found := re.match(r"\s*\[\[.*?\]\]|\s+", rest, re.S):
            place += found.end()
        else:
            return rest.rstrip(), place


def initialises_member(head):
    """Whether a '{' after this head is that of `a{1}` in `C() : a{1}, b{2} {`."""
    return (re.search(r"\)[^()]*?(?<!:):(?!:)", head) is not None
            and re.search(r"[\w>]$", head) is not None and not TAIL.search(head))


def kind_of(head):
    if NAMESPACE.match(head):
        return "namespace"
    if "(" in head and not head.endswith("=") or re.search(r"=\s*\[[^\]]*\]$", head):  # or a named lambda
        return "function"
    return "type" if TYPE.match(head) else "value"


class Reader:
    def __init__(self, text):
        self.text = blanked(text)
        self.lines = [found.start() for found in re.finditer("\n", text)]
        self.found = []

    def line(self, place):
        return bisect.bisect_left(self.lines, place) + 1

    def add(self, kind, level, head, start, last):
        short, cut = stripped(head)
        if short:
            self.found.append(Declaration(kind, level, short, self.line(start + cut), self.line(last)))

    def closing(self, place):
        """Where the brace opened at place is closed."""
        depth = 0
        for found in re.finditer(r"[{}]", self.text[place:]):
            depth += 1 if found.group() == "{" else -1
            if depth == 0:
                return place + found.start()
        return len(self.text) - 1

    def read(self, start, end, level):
        """Collects what is declared from start to end, both inside one block of this level."""
        place, parentheses = start, 0
        while place < end:
            sign = self.text[place]
            parentheses += {"(": 1, ")": -1}.get(sign, 0)
            if sign == ";" and parentheses == 0:
                self.add("statement", level, self.text[start:place], start, place)
                start = place + 1
            elif sign == "{":
                place, start = self.block(start, place, level, parentheses)
            place += 1
        return self.found

    def block(self, start, place, level, parentheses):
        """Reads the block opened at place; returns its end and where the next declaration starts."""
        head, last = self.text[start:place], self.closing(place)
        short, _ = stripped(head)
        kind = kind_of(short)
        if parentheses > 0 or kind == "function" and initialises_member(short):
            return last, start
        self.add(kind, level, head, start, last)
        if kind in ("namespace", "type") and not short.startswith("enum"):
            self.read(place + 1, last, kind)
        return last, last + 1


def declarations(text):
    reader = Reader(text)
    return reader.read(0, len(reader.text), "namespace")


def without_lists(head):
    """The head without what stands in angle brackets."""
    while (shorter := re.sub(r"<[^<>]*>", " ", head)) != head:
        head = shorter
    return head


def function_name(head):
    """The name before the arguments, with its class if the head has it; None if there is none."""
    if found := re.search(r"(?:[\w:]+::)?operator\s*(?:\(\)|[^\s(]+)", head):
        return found.group()
    if re.match(r"[^(=]*=\s*\[", head):  # a named lambda
        return value_name(head)
    names = re.findall(r"([~\w:]+)\s*\(", without_lists(head))
    return next((name for name in names if name not in NOT_NAMES), None)


def value_name(head):
    found = re.search(r"(\w+)\s*(?:\[[^\]]*\]\s*)*$", without_lists(re.split(r"=|\{", head, maxsplit=1)[0]))
    return found.group(1) if found else None


def type_name(head):
    found = re.match(r"(?:typedef\s+)?(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+([\w:]+)",
                     without_lists(head))
    return found.group(1) if found else None


def declared_name(declaration):
    """The name that a declaration at namespace level makes; None for forward declarations,
    operators, members defined outside of their class, and directives."""
    kind, _, head, *_ = declaration
    if kind == "namespace" or DIRECTIVE.match(head):
        return None
    if found := re.match(r"using\s+(\w+)[^=]*=", head):
        return found.group(1)
    if kind == "type":
        name = type_name(head)
    elif TYPE.match(head) and kind == "statement" and "(" not in head and "=" not in head:
        return None
    elif kind == "function" or "(" in without_lists(head.split("=")[0]):
        name = function_name(head)
    else:
        name = value_name(head)
    return None if name is None or "::" in name or name.startswith("operator") else name
