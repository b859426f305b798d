"""The common part of devices on an I2C bus: access to registers, and a bus of the mocks."""
