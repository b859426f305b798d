"""Facts of the specification that the checks of the generated suite compare with."""
