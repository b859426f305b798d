"""Render: views and templates to text, in memory."""

from functools import cache
from io import BytesIO

from jinja2 import BytecodeCache, Environment, FileSystemLoader, StrictUndefined
from jinja2.bccache import Bucket

from codegen.render.line_breaks import with_line_breaks
from codegen.tool.cache import entry, keep, kept
from codegen.tool.digest import surroundings
from codegen.tool.template_files import templates_folder


def render_template(name: str, view: object) -> str:
    """The text of the template ``name`` (posix path below the templates) with ``view`` as its one variable, ``view``.

    A name that is not defined, a missing template or a fault in one is an error of codegen itself and raises jinja2's
    exception: no input leads there.
    """
    return _environment().get_template(name).render(view=view)


def render_page(name: str, view: object) -> str:
    """The same for a page of HTML: what the view says is text and never markup, and long names break between words."""
    return with_line_breaks(_environment(is_escaping=True).get_template(name).render(view=view))


@cache
def _environment(*, is_escaping: bool = False) -> Environment:
    # Python, Markdown and JSON would be damaged by escaping.
    return Environment(
        loader=FileSystemLoader(templates_folder()),
        undefined=StrictUndefined,
        autoescape=is_escaping,  # noqa: S701
        keep_trailing_newline=True,
        trim_blocks=True,
        lstrip_blocks=True,
        bytecode_cache=_Compiled(),
    )


class _Compiled(BytecodeCache):
    """Templates as Jinja has compiled them, which depends on their source and on the options of the environment."""

    def load_bytecode(self, bucket: Bucket) -> None:
        """Called by Jinja before it compiles a template."""
        compiled = kept(_entry(bucket))
        if compiled is not None:
            bucket.load_bytecode(BytesIO(compiled))

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Called by Jinja after it has compiled one."""
        keep(_entry(bucket), bucket.bytecode_to_string())


def _entry(bucket: Bucket) -> str:
    options = {name: value for name, value in vars(bucket.environment).items() if isinstance(value, str | bool)}
    return entry("template", surroundings(), repr(sorted(options.items())), bucket.key, bucket.checksum)
