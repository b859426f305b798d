"""An INA226 on I2C."""
