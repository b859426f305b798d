"""The values of quantities: their sources, their ranges, and how long they are believed."""
