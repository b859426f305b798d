"""An INA219 on I2C."""
