"""A receiver of satellites on a UART."""
