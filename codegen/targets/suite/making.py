"""The call that makes a driver as literals: the generated suite compares with it, and evaluates nothing."""

import ast


def call_literal(expression: str) -> str:
    """Return a call as a literal of dicts, as Python writes it: what is called, and what is given in order and by name.

    A function without arguments, which a driver calls itself, stands for what it returns; a name by itself is a dict
    with the name alone.
    """
    return _literal(ast.parse(expression, mode="eval").body)


def _literal(node: ast.expr) -> str:
    match node:
        case ast.Lambda():
            return _literal(node.body)
        case ast.Call():
            given = ", ".join(map(_literal, node.args)) + ("," if len(node.args) == 1 else "")
            named = ", ".join(f'"{each.arg}": {_literal(each.value)}' for each in node.keywords)
            return f'{{"call": "{ast.unparse(node.func)}", "given": ({given}), "named": {{{named}}}}}'
        case ast.Name() | ast.Attribute():
            return f'{{"name": "{ast.unparse(node)}"}}'
    value = ast.literal_eval(node)
    return f'"{value}"' if isinstance(value, str) and value.isidentifier() else repr(value)
