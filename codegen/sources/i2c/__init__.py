"""What devices on an I2C bus have in common: access to registers, and a bus of the mocks."""
