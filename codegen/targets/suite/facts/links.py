"""Facts about the links, which the suite compares with how the board opens them."""

from codegen.frozen import dataclass
from codegen.model.program import BoardLink, LinkKind
from codegen.model.system import System


@dataclass(frozen=True, slots=True)
class LinkFacts:
    """A link: its kind as board.yaml has it, and its settings by their names there, with times in ms."""

    kind: str
    settings: dict[str, object]


def link_facts(system: System) -> tuple[LinkFacts, ...]:
    """Return the links of the board, in their order; pins only where the board lets a program choose them."""
    chooses_pins = system.board is not None and system.board.tells_uart_pins
    return tuple(LinkFacts(link.kind.value, _settings(link, chooses_pins)) for link in system.links)


def _settings(link: BoardLink, chooses_pins: bool) -> dict[str, object]:
    spec = link.spec
    if link.kind is LinkKind.UART:
        pins = {"tx": spec.tx, "rx": spec.rx} if chooses_pins else {}
        return {"name": link.name, "uart": spec.uart, **pins, "baud": spec.baud, "size": spec.buffer}
    if link.kind is LinkKind.USB:
        return {"name": link.name, "size": spec.buffer}
    wifi = {"credentials": spec.credentials or "", "retry_ms": link.retry_ms}
    if link.kind is LinkKind.UDP:
        return {"name": link.name, "to": spec.to or "", "udp": spec.udp, "local_port": spec.local_port, **wifi}
    wifi["timeout_ms"] = link.timeout_ms
    if link.kind is LinkKind.TCP_SERVER:
        return {"name": link.name, "tcp_server": spec.tcp_server, "backlog": spec.tcp_backlog, **wifi}
    return {"name": link.name, "to": spec.to or "", "tcp_client": spec.tcp_client, **wifi}
