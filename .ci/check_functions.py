"""Fails if a function of production code is too long or has too many parameters (CONTRIBUTING.md).

    check_functions.py [--self-test]

Prints file:line of every such function.  The length is that of the body with its braces and the
lambdas in it.  Parameters with a default count, parameters of lambdas do not.  Tests are exempt.
"""

import re
import sys
from dataclasses import dataclass

from source_files import lines_of, source_files

MOST_LINES = 40
MOST_PARAMETERS = 5
FOLDERS = ("bench/", "common/", "convert/", "experiments/", "preprocess/", "render/")

# (file, function) -> why it may be longer or have more parameters, for instance because a library
# prescribes its signature.
EXCEPTIONS = {}

# Comments, strings and directives: their brackets and commas are not code.
TEXT = re.compile(r"""//[^\n]*|/\*.*?\*/
                   |R"([^(\s]*)\(.*?\)\1"
                   |"(?:\\.|[^"\\\n])*"
                   |(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'
                   |^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*""", re.VERBOSE | re.DOTALL | re.MULTILINE)
CLOSING = {"(": ")", "[": "]", "{": "}"}
SCOPE = re.compile(r"(?:inline\s+)?namespace\b|extern\s*$"
                   r"|(?:(?:typedef|static|inline|constexpr|alignas\s*\([^)]*\))\s+)*"
                   r"(?:class|enum|struct|union)\b")
BEFORE = re.compile(r"\s*(?:(?:public|private|protected)\s*:(?!:)\s*)*")
NAME = re.compile(r"(?:\w+\s*::\s*)*(?:operator\s*(?:\(\s*\)|[^\s(\w]+|[\w:&*\s]+?)|~?\w+)"
                  r"(?=\s*\()")
WORD = re.compile(r"\w+")
NOT_NAMES = {"alignas", "decltype", "explicit", "noexcept", "requires", "__attribute__"}
MEMBER_LIST = re.compile(r"\s*(?:noexcept\s*)?:(?!:)")


@dataclass
class Signature:
    name: str
    begin: int  # of the name
    end: int  # of the parameters
    parameters: int


@dataclass
class Function:
    name: str
    line: int
    lines: int  # of the body
    parameters: int


def without_text(code):
    """Replaces comments, strings and directives by blanks; line numbers stay the same."""
    return TEXT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), code)


def end_of_bracket(code, begin):
    """The place behind the bracket that closes the one at `begin`."""
    waiting = []
    for at in range(begin, len(code)):
        if code[at] in CLOSING:
            waiting.append(CLOSING[code[at]])
        elif waiting and code[at] == waiting[-1]:
            waiting.pop()
            if not waiting:
                return at + 1
    return len(code)


def end_of_angle(code, begin):
    """The place behind the > that closes the < at `begin`."""
    depth, at = 0, begin
    while at < len(code):
        if code[at] in CLOSING:
            at = end_of_bracket(code, at)
            continue
        depth += (code[at] == "<") - (code[at] == ">" and code[at - 1] != "-")
        at += 1
        if depth == 0:
            break
    return at


def skip(code, at):
    """The place behind the word, character or pair of brackets at `at`."""
    if code[at] in CLOSING:
        return end_of_bracket(code, at)
    if code[at] == "<":
        return end_of_angle(code, at)
    word = WORD.match(code, at)
    return word.end() if word else at + 1


def count_parameters(inside):
    """How many parameters the text between a function's parentheses has."""
    if inside.strip() in ("", "void"):
        return 0
    count, at = 1, 0
    while at < len(inside):
        count += inside[at] == ","
        at = skip(inside, at)
    return count


def begin_of_declaration(head):
    """The place behind access specifiers and `template <...>`."""
    at = BEFORE.match(head).end()
    while head.startswith("template", at):
        at = end_of_angle(head, head.index("<", at))
        at += len(head[at:]) - len(head[at:].lstrip())
    return at


def signature_of(head):
    """Signature of the function whose body follows `head`; None if no body follows."""
    at = begin_of_declaration(head)
    while at < len(head) and head[at] != "=":
        name = NAME.match(head, at)
        if name and name.group() not in NOT_NAMES:
            opening = head.index("(", name.end())
            end = end_of_bracket(head, opening)
            in_list = MEMBER_LIST.match(head, end)
            if in_list and re.search(r"[\w>]\s*$", head[in_list.end():]):
                return None  # the brace holds the value of a member
            return Signature(name.group(), at, end, count_parameters(head[opening + 1:end - 1]))
        at = skip(head, at)
    return None


def functions_of(code):
    """Functions with a body in a file's text, in order; not those within functions."""
    code = without_text(code)
    found = []
    head, at = 0, 0  # where a declaration begins, and how far it is read
    while at < len(code):
        if code[at] in ";}":
            at += 1
            head = at
        elif code[at] == "{":
            text = code[head:at]
            if SCOPE.match(text, begin_of_declaration(text)):
                at += 1
                head = at
                continue
            end = end_of_bracket(code, at)
            signature = signature_of(text)
            if signature:
                line = code.count("\n", 0, head + signature.begin) + 1
                lines = code.count("\n", at, end) + 1
                found.append(Function(signature.name, line, lines, signature.parameters))
                head = end
            at = end
        elif code[at] in CLOSING:
            at = end_of_bracket(code, at)
        else:
            at += 1
    return found


def problems_of(name, code):
    """(function, message) for every limit that a function of file `name` exceeds."""
    problems = []
    for function in functions_of(code):
        place = f"{name}:{function.line}: {function.name} has"
        if function.lines > MOST_LINES:
            problems.append((function.name, f"{place} {function.lines} lines, {MOST_LINES} at "
                                            "most: divide it"))
        if function.parameters > MOST_PARAMETERS:
            problems.append((function.name, f"{place} {function.parameters} parameters, "
                                            f"{MOST_PARAMETERS} at most: make a struct of some"))
    return problems


def check(files):
    """Messages on {name: code}: limits exceeded, and exceptions that no function needs."""
    problems, used = [], set()
    for name, code in files.items():
        for function, problem in problems_of(name, code):
            if (name, function) in EXCEPTIONS:
                used.add((name, function))
            else:
                problems.append(problem)
    unused = [f"{name}: {function} needs no exception: remove it from .ci/check_functions.py"
              for name, function in EXCEPTIONS.keys() - used]
    return problems + sorted(unused)


def self_test():
    """The check finds what is wrong and accepts what is right."""
    long_body = "{\n" + "    act();\n" * (MOST_LINES - 1) + "}\n"
    fitting_body = "{\n" + "    act();\n" * (MOST_LINES - 2) + "}\n"
    six = "int a, int b, int c, int d, int e, int f"
    wrong = ["void a()\n" + long_body,
             "struct A {\n    int b = 0;\n    void a()\n" + long_body + "};\n",
             "namespace b::c {\nnamespace {\nvoid a()\n" + long_body + "}\n}\n",
             "A::A(int a)\n    : b_{a}, c_(a)\n" + long_body,
             "bool A::operator()(int a) const\n" + long_body,
             "template <typename T>\n    requires(sizeof(T) > 1)\nvoid a()\n" + long_body,
             f"void a({six}) {{}}",
             f"class A : public B {{\n  public:\n    A({six}) : a_(a) {{}}\n}};",
             f"bool operator<({six}) {{ return false; }}",
             "template <typename A = B<1, 2>>\nstd::map<int, int> a(int b, std::map<int, C> c, int d"
             " = 1, int e = f(1, 2), int g = {}, const D& h = {})\n{\n}\n",
             'extern "C" {\nvoid a(' + six + ") {}\n}",
             f"#if A\nvoid a({six}) {{}}\n#endif\n"]
    right = ["void a()\n" + fitting_body,
             "void a(std::map<int, std::pair<int, int>> b, int c, int d, int e, int f = g(1, 2)) {}",
             f"void a({six});",
             f"void a()\n{{\n    const auto b = [&]({six}) {{ return 0; }};\n}}\n",
             f"const auto a = [&]({six}) {{ return 0; }};",
             f"// void a({six}) {{}}\n/* void a({six}) {{}} */\n",
             f'const char* a = "void a({six}) {{";\nconst char* b = R"(void a({six}) {{}})";\n',
             f"#define A({six}) {{}}\n",
             "struct A {\n" + "    int a;\n" * (MOST_LINES + 1) + "};\n",
             "constexpr A kA[] = {\n" + "    {1, 2},\n" * (MOST_LINES + 1) + "};\n",
             "enum class A { a, b, c, d, e, f, g };\nvoid a() {}\n"]
    missed = [code for code in wrong if len(check({"a.cpp": code})) != 1 + len(EXCEPTIONS)]
    blamed = [code for code in right if len(check({"a.cpp": code})) != len(EXCEPTIONS)]
    assert not missed and not blamed, f"missed {missed}, blamed {blamed}"


def main():
    if "--self-test" in sys.argv[1:]:
        self_test()
        return 0
    problems = check({name: "\n".join(lines_of(name)) for name in source_files()
                      if name.startswith(FOLDERS)})
    print("\n".join(problems) or f"every function has at most {MOST_LINES} lines and "
                                 f"{MOST_PARAMETERS} parameters")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
